#pragma once

#include <limits>
#include <optional>
#include <span>

#include "tissue/agents/AgentStore.h"
#include "tissue/agents/BondTable.h"
#include "tissue/biology/Activation.h"
#include "tissue/biology/ArrestRules.h"
#include "tissue/biology/BiologySettings.h"
#include "tissue/biology/CellCycle.h"
#include "tissue/biology/ContactInhibition.h"
#include "tissue/biology/Division.h"
#include "tissue/biology/Endothelium.h"
#include "tissue/biology/ExtracellularMatrix.h"
#include "tissue/biology/NitricOxide.h"

namespace restenosis {

/// The biological rules of a scene (model 5 to 7), in the parts that a step calls in the order of model 9:
/// updateEndothelium, updateNitricOxide, updateInhibition, advanceCycle. Endothelium settles on cells that
/// the last updateInhibition found exposed, so call that once before the first step. Each part reads the
/// state that the earlier ones left; its result does not depend on the order of agents or on threads. Before
/// all of them the agents get what the scene models (model, stretch, begin).
class Biology {
 public:
  /// Throws std::invalid_argument for an unknown law or scenario and for nitric oxide that falls with WSS.
  explicit Biology(const BiologySettings& settings,
                   std::span<const MakeArrestRule> rules = arrestRuleTable());

  /// Gives agents the quantities that the scene models beside those that all have.
  void model(AgentStore& agents) const;
  /// The wall has been deployed, and is not injured yet. `strain`: of the tissue around the vessel, by agent.
  void stretch(AgentStore& agents, std::span<const double> strain) const;
  /// The wall has been injured: activates cells; endothelium that is left is mature. Returns how many cells
  /// are synthetic by stretch alone.
  Index begin(AgentStore& agents) const;
  bool hasActivation() const { return activation_.has_value(); }

  bool hasCycle() const { return cycle_.has_value(); }
  bool hasEndothelium() const { return endothelium_.has_value(); }

  /// Sets the flags `inhibited` and `exposed`.
  InhibitionReport updateInhibition(AgentStore& agents) { return inhibition_.evaluate(agents); }
  /// Call after agents were reordered: place k has the agent of former index order[k]. Speed only.
  void reorder(std::span<const Index> order) { inhibition_.reorder(order); }
  /// Sets the flag `covered` for `time` [s] since the end of deployment.
  CoverageReport updateEndothelium(AgentStore& agents, double time) const;
  /// Sets nitric oxide from the WSS that agents hold.
  void updateNitricOxide(AgentStore& agents) const;
  /// Advances the cells by the step that begins at `time` [s] (by default long after deployment), lets them
  /// lay down matrix and divides those that are due; `bonds` grows with the agents. Activation and
  /// endothelium grow older by a step.
  CycleReport advanceCycle(AgentStore& agents, BondTable& bonds,
                           double time = std::numeric_limits<double>::infinity()) const;

  /// The rules by which cells rest; they say which cells read wall shear stress.
  const ArrestRules& rules() const { return rules_; }
  /// Time of the first coverage [s]; infinity where there is never any.
  double endotheliumOnset() const;
  /// Time from which on endothelium is whole [s]; infinity where it never is.
  double endotheliumCompletion() const;
  /// WSS [Pa] at which a covered cell is sent to rest; infinity without endothelium.
  double arrestingWss() const;

  /// The state that is not in the agents: part of a checkpoint.
  template <class Archive>
  void archive(Archive& a) {
    a(inhibition_);
  }

 private:
  ArrestRules rules_;
  ContactInhibition inhibition_;
  std::optional<Endothelium> endothelium_;
  std::optional<NitricOxide> nitricOxide_;
  std::optional<Activation> activation_;
  std::optional<ExtracellularMatrix> matrix_;
  std::optional<CellCycle> cycle_;
  std::optional<Division> division_;
  double step_;
  bool endotheliumMatures_;
};

}  // namespace restenosis

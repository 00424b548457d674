#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "tissue/agents/AgentStore.h"
#include "tissue/agents/BondTable.h"
#include "tissue/biology/CellCycle.h"
#include "tissue/biology/CellCycleParameters.h"
#include "tissue/biology/ContactInhibition.h"
#include "tissue/biology/ContactInhibitionParameters.h"
#include "tissue/biology/Division.h"
#include "tissue/biology/Endothelium.h"
#include "tissue/biology/EndotheliumParameters.h"
#include "tissue/biology/NitricOxide.h"
#include "tissue/biology/StateCounts.h"

namespace restenosis {

/// What a scene says of biology. A section that is absent is not modelled: without the cycle nothing divides,
/// without contact inhibition nothing is inhibited, without endothelium there is no coverage and no nitric
/// oxide.
struct BiologySettings {
  std::optional<CellCycleParameters> cellCycle;
  std::optional<ContactInhibitionParameters> contactInhibition;
  std::optional<EndotheliumParameters> endothelium;
  bool denuded = true;  ///< whether deployment stripped the endothelium; else it covers all from the start
  std::uint64_t seed = 1;
  double step = 3600;       ///< biological step [s]
  double vesselLength = 0;  ///< [m]; 0: no ends
};

/// The biological rules of a scene (model 5 to 7), in the parts that a step calls in the order of model 9:
/// updateEndothelium, updateNitricOxide, updateInhibition, advanceCycle. Endothelium settles on cells that
/// the last updateInhibition found exposed, so that is called once before the first step. Each part reads the
/// state that the earlier ones left and cannot be changed by the order of agents or by threads.
class Biology {
 public:
  /// Throws std::invalid_argument for an unknown law or scenario and for nitric oxide that falls with WSS.
  explicit Biology(const BiologySettings& settings);

  bool hasCycle() const { return cycle_.has_value(); }
  bool hasEndothelium() const { return endothelium_.has_value(); }

  /// Sets the flags `inhibited` and `exposed`.
  InhibitionReport updateInhibition(AgentStore& agents) { return inhibition_.evaluate(agents); }
  /// To be told where agents have changed places: to place k came the one of order[k]. Speed only.
  void reorder(std::span<const Index> order) { inhibition_.reorder(order); }
  /// Sets the flag `covered` for `time` [s] since the end of deployment.
  CoverageReport updateEndothelium(AgentStore& agents, double time) const;
  /// Sets nitric oxide from the WSS that agents hold.
  void updateNitricOxide(AgentStore& agents) const;
  /// Takes the cells through the step that begins at `time` [s] (by default long after deployment) and
  /// divides those that are due; `bonds` grows with the agents.
  CycleReport advanceCycle(AgentStore& agents, BondTable& bonds,
                           double time = std::numeric_limits<double>::infinity()) const;

  /// Time of the first coverage [s]; infinity where there is never any. Before it no rule reads WSS.
  double endotheliumOnset() const;
  /// WSS [Pa] at which a covered cell is sent to rest; infinity without endothelium. While every covered cell
  /// stays on its side of it, flow changes no cell's state.
  double arrestingWss() const;

  /// The state that is not in the agents: part of a checkpoint.
  template <class Archive>
  void archive(Archive& a) {
    a(inhibition_);
  }

 private:
  ContactInhibition inhibition_;
  std::optional<Endothelium> endothelium_;
  std::optional<NitricOxide> nitricOxide_;
  std::optional<CellCycle> cycle_;
  std::optional<Division> division_;
};

}  // namespace restenosis

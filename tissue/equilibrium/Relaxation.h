#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

#include "tissue/agents/AgentStore.h"
#include "tissue/agents/BondTable.h"
#include "tissue/equilibrium/Constraint.h"
#include "tissue/equilibrium/RelaxationParameters.h"
#include "tissue/equilibrium/RelaxationReport.h"
#include "tissue/forces/ForceField.h"
#include "tissue/forces/MechanicsParameters.h"

namespace restenosis {

/// Thrown when `maximumIterations` did not reach the tolerance and `stopAtMaximum` is false. The message
/// names the settings to change.
struct RelaxationFailed : std::runtime_error {
  RelaxationFailed(const std::string& message, const RelaxationReport& done, AgentId worst)
      : std::runtime_error(message), report(done), worstAgent(worst) {}
  RelaxationReport report;
  AgentId worstAgent;  ///< that of the largest residual
};

/// Moves agents to mechanical equilibrium (model 3): until the force left on no free agent would move it by
/// more than `tolerance` of its radius, no agent moving more than `stepLimit` of its radius in a step.
///
/// Only an active set is moved, unless it would be large (Equilibration). Results do not depend on the number
/// of threads.
class Relaxation {
 public:
  /// Skin of the neighbour list over the reference radius. Speed only: results do not depend on it.
  static constexpr double skinOverRadius = 0.4;

  /// `referenceRadius` is r0 of the characteristic force [m]. Throws std::invalid_argument for an unknown
  /// law.
  Relaxation(const MechanicsParameters& mechanics, const RelaxationParameters& parameters,
             double referenceRadius);
  ~Relaxation();
  Relaxation(const Relaxation&) = delete;
  Relaxation& operator=(const Relaxation&) = delete;

  /// Called before every iteration. It may throw to give the relaxation up, which leaves agents somewhere on
  /// their path.
  void setCallback(std::function<void()> beforeIteration) { beforeIteration_ = std::move(beforeIteration); }

  /// Relaxes in place. `constraints` may be empty. Flags `fixed` and kind `strut` are never moved. Updates
  /// AgentStore::stress of the agents it evaluated.
  RelaxationReport relax(AgentStore& agents, const BondTable& bonds,
                         std::span<const Constraint* const> constraints);

  /// The same to the last bit, where since the last call agents have moved, grown or been appended and
  /// nothing else has changed: the arguments are the same objects, constraints and bonds are as they were.
  /// Costs what has changed and what moves. Agents in another order, and the first call, are dealt with as by
  /// relax().
  RelaxationReport relaxAgain(AgentStore& agents, const BondTable& bonds,
                              std::span<const Constraint* const> constraints);

  /// Frees the memory that relaxAgain would go on from; it costs time only. Nothing is known of the last
  /// relaxation then.
  void forget();

 private:
  /// How to compute in mixed precision; nothing where double precision is asked for or needed.
  std::optional<FixedScale> mixedScale() const;

  RelaxationParameters parameters_;
  std::function<void()> beforeIteration_;
  ForceField field_;
  double contactModulus_;
  double referenceRadius_;
  NeighbourList neighbours_;                            ///< kept between relaxations: speed only
  std::unique_ptr<class Equilibration> equilibration_;  ///< kept for relaxAgain: speed only
};

}  // namespace restenosis

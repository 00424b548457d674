#pragma once

#include <cstdint>

#include "tissue/agents/AgentStore.h"
#include "tissue/biology/EndotheliumParameters.h"
#include "tissue/biology/EndotheliumScenario.h"

namespace restenosis {

/// Numbers of cells in a draw of coverage.
struct CoverageReport {
  Index exposed = 0;       ///< cells beside the lumen on which endothelium may settle
  Index covered = 0;       ///< of these, how many carry endothelium after the draw
  Index newlyCovered = 0;  ///< of these, how many are new
};

/// Return of the endothelium over the exposed synthetic cells, seeded at random places (model 7).
///
/// Every agent has one uniform number u, drawn by (seed, id). With n exposed cells and k of them covered, a
/// draw at time t covers the round(c(t) n) - k bare ones of smallest u, and none if k is that many already.
/// So:
/// - as long as cells neither divide nor move, a cell is covered once u is below c(t), to within one sampling
///   error, and the cells covered earlier stay among those covered later;
/// - coverage is never lost, and daughters inherit it. Covered cells that divide therefore raise the coverage
///   above c(t), bare ones that divide lower it; an independent draw u < c(t) for each cell would keep that
///   bias. Counting the cells covered already removes it: coverage is c(t) to within half a cell, or, where
///   inheritance has raised it above, constant until c(t) has reached it;
/// - a daughter that becomes exposed and is bare is part of the next draw, and at c = 1 no exposed cell is
///   bare.
/// The result depends on ids and flags only, not on the order of agents or threads, and needs no state of its
/// own.
///
/// Where maturation is modelled, new endothelium has the maturity 0, which grows as 1 - exp(-age /
/// maturationTime). Endothelium that deployment left is mature.
class Endothelium {
 public:
  /// Where not `denuded`, cells are covered from the start in every scenario. Throws std::invalid_argument
  /// for an unknown scenario.
  Endothelium(const EndotheliumParameters& parameters, std::uint64_t seed, bool denuded);

  /// Coverage c(t) to reach at `time` [s].
  double target(double time) const;
  /// Time of the first coverage [s]; infinity for never.
  double onset() const;
  /// Time from which on it is whole [s]; infinity for never.
  double completion() const;
  /// Deployment is over: endothelium that it left is mature.
  void begin(AgentStore& agents) const;
  /// `duration` [s] has passed since the last call.
  void mature(AgentStore& agents, double duration) const;
  /// Sets the flag `covered`; reads `exposed`, `synthetic` and the kind.
  CoverageReport apply(AgentStore& agents, double time) const;

 private:
  EndotheliumScenario scenario_;
  std::uint64_t seed_;
  bool denuded_;
  double maturationTime_;
};

}  // namespace restenosis

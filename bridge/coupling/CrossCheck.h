#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "bridge/coupling/AlikeRemarks.h"
#include "bridge/flow/FlowBackend.h"
#include "bridge/output/CrossCheckRecord.h"
#include "bridge/surface/TriSurface.h"
#include "tissue/biology/Biology.h"

namespace restenosis {

/// What the cross-checks of a run have found, and the lumen that waits for one.
struct CrossCheckState {
  std::vector<CrossCheckRecord> checks;
  std::uint64_t failed = 0;
  std::uint64_t solvesSeen = 0;       ///< of FlowState::solves
  std::optional<TriSurface> pending;  ///< lumen of the last solve, as long as that has not been checked
  AlikeRemarks remarked;              ///< in RunState::remarks

  template <class Archive>
  void archive(Archive& a) {
    a(checks, failed, solvesSeen, pending, remarked);
  }
};

/// How `other` differs from `own`, both solved in this lumen, for the parts of a lumen (comparedFaces).
/// `struts`: places on the struts' middles. Time and decisions are left to the caller.
CrossCheckRecord stressDifferences(const TriSurface& lumen, std::span<const Vec3> struts,
                                   const FlowSolution& own, const FlowSolution& other);

/// Share of the covered cells that rest by the stress of one flow and not by that of the other; none where no
/// cell is covered.
std::optional<double> decidedOtherwise(const AgentStore& agents, const Biology& biology,
                                       const FlowSolution& own, const FlowSolution& other);

}  // namespace restenosis

#pragma once

#include <optional>

#include "tissue/stent/Stent.h"
#include "tissue/vessel/Wall.h"

namespace restenosis {

/// Measures of a deployed wall. A mean over nothing is absent.
struct DeploymentStatistics {
  Index freeInPath = 0;   ///< wall agents in the path of a strut that are free to move
  Index escaped = 0;      ///< wall agents in the path of a strut that lie lumenward of its outer face
  Index escapedFree = 0;  ///< of these, the ones free to move
  Index passedFree = 0;   ///< of these, the ones lumenward of it by more than half a cell radius
  Index outside = 0;      ///< cells outside the EEL
  std::optional<double> ielUnderStrut;   ///< mean distance of the IEL from the axis under struts [m]
  std::optional<double> laminaDistance;  ///< mean IEL-to-EEL distance under struts [m]
  double largestOverlap = 0;            ///< of two agents that are not both struts, over the mean cell radius
  std::optional<double> meanIelStrain;  ///< of bonds between IEL agents
  double largestIelStrain = 0;          ///< the same
  std::optional<double> meanStrain;     ///< of all bonds
  double largestStrain = 0;             ///< the same

  template <class Archive>
  void archive(Archive& a) {
    a(freeInPath, escaped, escapedFree, passedFree, outside, ielUnderStrut, laminaDistance, largestOverlap,
      meanIelStrain, largestIelStrain, meanStrain, largestStrain);
  }
};

/// Measures a wall around a stent where it now stands. "Under a strut" is the middle half of its width; an
/// agent is "in the path" of a strut if its centre is at least half a cell radius from the strut's edges, so
/// that cells pressed against the strut's side do not count. Agents of the vessel's fixed ends, and of an EEL
/// that is held, are not free to move.
DeploymentStatistics measureDeployment(const Wall& wall, const Stent& stent);

}  // namespace restenosis

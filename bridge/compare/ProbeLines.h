#pragma once

#include <vector>

#include "bridge/surface/TriSurface.h"

namespace restenosis {

/// Points in a lumen at which velocities are compared.
struct ProbeLines {
  std::vector<Vec3> axis;  ///< centres of cross-sections, from inlet to outlet [m]
  struct Plane {
    double z;                  ///< [m]
    std::vector<Vec3> points;  ///< a square grid over the cross-section, those well inside it [m]
    double spacing;            ///< of the grid [m]
  };
  std::vector<Plane> planes;
  std::vector<Vec3> others;  ///< that were asked for [m]

  /// All of them, in this order.
  std::vector<Vec3> points() const;
};

/// How many (assumed). Points nearer to the wall than `clearance` of the cross-section's radius are left out:
/// what lies between the last cell and the wall is each method's own interpolation.
struct ProbeSettings {
  int axisPoints = 100;
  int planes = 5;
  int acrossPlane = 40;
  double clearance = 0.1;
};

ProbeLines probeLines(const TriSurface& lumen, const ProbeSettings& settings = {});

}  // namespace restenosis

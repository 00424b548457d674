#pragma once

#include <gtest/gtest.h>

#include "tests/support/FlowSupport.h"

namespace restenosis::support {

/// How near Poiseuille's solution a backend's must come in the vessel of FlowSupport.
struct PoiseuilleLimits {
  double stressMean, stressL2, pressureDrop, massImbalance;
  double endMargin = 0.0;  ///< left out at either end [m]
};

/// What `draft` keeps to in a plain tube of 1.2 mm, whatever its direction: measured are 0.5 and 1.0 %, at
/// most 2.1 %.
inline constexpr double meanLimit = 0.01, l2Limit = 0.015;
/// The inlet's profile vanishes at the circle, not on the meshed polygon: the faces next to it are left out.
inline constexpr double endMargin = 0.1e-3;

inline void expectPoiseuille(const FlowSolution& s, const PoiseuilleLimits& limits) {
  const auto error = stressError(s, vesselStress(), limits.endMargin, vesselLength - limits.endMargin);
  EXPECT_LT(std::abs(error.mean), limits.stressMean);
  EXPECT_LT(error.l2, limits.stressL2);
  EXPECT_NEAR(s.pressureDrop / (vesselConditions().pressureGradient * vesselLength), 1.0,
              limits.pressureDrop);
  EXPECT_LT(s.massImbalance, limits.massImbalance);
  EXPECT_TRUE(s.remarks.empty());
  double area = 0.0;
  for (const auto& face : s.wall) {
    area += face.area;
    ASSERT_GT(face.traction.z(), 0.0);
  }
  EXPECT_NEAR(area / (2.0 * std::numbers::pi * vesselRadius * vesselLength), 1.0, 0.005);
}

/// The strut's top within `topRadius` [m] of the axis, in stentedTube with a strut 90 um thick half way.
struct StrutTop {
  double stress = 0.0;  ///< mean [Pa]
  double area = 0.0;    ///< [m^2]
};

/// Expects the undisturbed stress ahead of the strut and little beside it; returns what its top feels.
inline StrutTop expectStrutDisturbs(const FlowSolution& s, double topRadius) {
  EXPECT_LT(std::abs(stressError(s, vesselStress(), 0.05e-3, 0.2e-3).mean), 0.05);
  EXPECT_LT(stressError(s, vesselStress(), 0.66e-3, 0.75e-3).mean, -0.7);
  StrutTop top;
  for (const auto& f : s.wall) {
    if (f.region != SurfaceRegion::strut || f.centre.head<2>().norm() >= topRadius) continue;
    top.stress += f.area * f.traction.z(), top.area += f.area;
  }
  top.stress /= top.area;
  return top;
}

}  // namespace restenosis::support

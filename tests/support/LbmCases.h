#pragma once

#include <cmath>
#include <numbers>

#include "bridge/flow/lbm/LbmBackend.h"
#include "tests/support/EllipticDuct.h"
#include "tests/support/FlowSupport.h"
#include "tests/support/LatticeSupport.h"

namespace restenosis::support {

/// Stress in the middle tenth of a tube turned by an angle from the lattice, solved with open ends, which are
/// cut along the lattice, against Poiseuille's.
inline StressError turnedTubeError(double degrees, int nodesAcross, const char* wall = "interpolated",
                                   const char* stress = "adaptive") {
  const double angle = degrees * std::numbers::pi / 180.0, radius = 0.5e-3, length = 3e-3;
  // Through the ends, cut obliquely, flows what flows along the axis
  const FlowConditions conditions = slowConditions(std::numbers::pi * radius * radius);
  LbmSettings settings;
  settings.dx = 2.0 * radius / nodesAcross;
  settings.wall = wall;
  settings.stress = stress;
  LbmBackend backend(settings);
  const auto s = backend.solve(turnedTube(radius, length, angle), conditions, {});
  return stressError(s, 4.0 * conditions.dynamicViscosity() * 1e-3 / radius, 0.45 * length, 0.55 * length);
}

inline EllipticError ellipticDuctError(int nodesAcross) {
  LbmSettings settings;
  settings.dx = 2.0 * EllipticFlow{}.a / nodesAcross;
  LbmBackend backend(settings, nullptr, true);
  return ellipticDuctError(backend, {});
}

}  // namespace restenosis::support

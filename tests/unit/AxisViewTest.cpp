#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bridge/flow/foam/AxisView.h"
#include "tests/support/Constants.h"
#include "tests/support/TubeSurface.h"

namespace restenosis {
namespace {

using support::revolve;
using support::tube;

TEST(AxisView, ATubeIsSeenAsItsRadius) {
  const AxisView view(tube(0.9e-3, support::vesselLength), 7, 24);
  for (int k = 0; k <= view.planes(); ++k)
    for (int a = 0; a < view.angles(); ++a) EXPECT_NEAR(view.radius(k, a), 0.9e-3, 1e-6) << k << " " << a;
  EXPECT_EQ(view.undercut(), 0.0);
}

TEST(AxisView, TheAxisJoinsTheEnds) {
  TriSurface lumen = tube(0.9e-3, support::vesselLength);
  for (Vec3& v : lumen.vertices) v += Vec3(1e-3 + 0.3 * v.z(), -2e-3, 5e-3);
  const AxisView view(lumen, 4, 24);
  EXPECT_NEAR((view.axis(0) - Vec3(1e-3, -2e-3, 5e-3)).norm(), 0.0, 1e-9);
  EXPECT_NEAR(
      (view.axis(4) - Vec3(1e-3 + 0.3 * support::vesselLength, -2e-3, 5e-3 + support::vesselLength)).norm(),
      0.0, 1e-9);
  for (int k = 0; k <= 4; ++k)
    for (int a = 0; a < 24; ++a) EXPECT_NEAR(view.radius(k, a), 0.9e-3, 1e-6) << k << " " << a;
}

TEST(AxisView, WhatLiesBehindIsCounted) {
  // A brim that leans over a groove
  const AxisView view(revolve({{0.9e-3, 0},
                               {0.9e-3, 0.6e-3},
                               {0.7e-3, 0.3e-3},
                               {0.7e-3, 0.8e-3},
                               {0.9e-3, 0.9e-3},
                               {0.9e-3, support::vesselLength}}),
                      12, 24);
  EXPECT_NEAR(view.radius(4, 0), 0.7e-3, 1e-6) << "the brim, not the wall behind it";
  EXPECT_NEAR(view.radius(1, 0), 0.9e-3, 1e-6);
  EXPECT_NEAR(view.undercut(), 2.0 / 13.0, 0.08) << "of the planes between 0.3 and 0.6 mm";
}

TEST(AxisView, ALumenThatItsAxisLeavesIsRefused) {
  TriSurface lumen = tube(0.3e-3, support::vesselLength, 40);
  for (Vec3& v : lumen.vertices) v.x() += 1e-3 * std::sin(std::numbers::pi * v.z() / support::vesselLength);
  EXPECT_THROW(AxisView(lumen, 12, 24), std::invalid_argument);
}

}  // namespace
}  // namespace restenosis

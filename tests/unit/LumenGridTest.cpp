#include <gtest/gtest.h>

#include <limits>

#include "LumenGrid.h"

namespace restenosis {
namespace {

TEST(LumenGrid, HasNodesOnBothEndsAndTheAxis) {
  const LumenGrid g(1.234e-3, 0.5e-3, 15e-6);
  EXPECT_EQ(g.z(0), 0.0);
  EXPECT_EQ(g.z(g.nz - 1), 1.234e-3);
  EXPECT_EQ(g.x((g.nx - 1) / 2), 0.0);
  EXPECT_GE(g.x(g.nx - 1), 0.5e-3);
  EXPECT_NEAR(g.spacingZ, 15e-6, 0.1e-6);
}

TEST(LumenGrid, RefusesWhatIsNoSize) {
  EXPECT_THROW(LumenGrid(0, 1, 1), std::invalid_argument);
  EXPECT_THROW(LumenGrid(1, -1, 1), std::invalid_argument);
  EXPECT_THROW(LumenGrid(1, 1, std::numeric_limits<double>::quiet_NaN()), std::invalid_argument);
}

TEST(GridField, InterpolatesTrilinearFunctionsExactly) {
  const LumenGrid g(1.0, 1.0, 0.25);
  auto f = [](const Vec3& p) { return 1 + 2 * p.x() - p.y() + 3 * p.z() + 0.5 * p.x() * p.y() * p.z(); };
  GridField field(g, 0);
  for (int k = 0; k < g.nz; ++k)
    for (int j = 0; j < g.ny; ++j)
      for (int i = 0; i < g.nx; ++i) field.values[g.index(i, j, k)] = static_cast<float>(f(g.node(i, j, k)));
  const Vec3 p(0.1, -0.3, 0.6);
  Vec3 gradient;
  // Within a cell the interpolant of x y z is exact.
  EXPECT_NEAR(field.at(p, gradient), f(p), 1e-6);
  EXPECT_NEAR(gradient.x(), 2 + 0.5 * p.y() * p.z(), 1e-5);
  EXPECT_NEAR(gradient.y(), -1 + 0.5 * p.x() * p.z(), 1e-5);
  EXPECT_NEAR(gradient.z(), 3 + 0.5 * p.x() * p.y(), 1e-5);
  EXPECT_NEAR(field.inPlane(0.1, -0.3, 2), f({0.1, -0.3, g.z(2)}), 1e-6);
}

}  // namespace
}  // namespace restenosis

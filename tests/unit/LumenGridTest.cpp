#include <gtest/gtest.h>

#include <limits>

#include "bridge/surface/LumenGrid.h"

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

}  // namespace
}  // namespace restenosis

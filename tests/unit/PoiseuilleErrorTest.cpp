#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "Constants.h"
#include "FlowSupport.h"
#include "PoiseuilleError.h"

namespace restenosis {
namespace {

using namespace support;

TEST(PoiseuilleError, WeighsByAreaAndLeavesTheEndsOut) {
  const double exact = vesselStress();
  const std::vector<WallFace> faces = {
      {Vec3(0, 0, 0.6e-3), 3e-9, Vec3(0, 0, 1.02 * exact), SurfaceRegion::wall},
      {Vec3(0, 0, 0.7e-3), 1e-9, Vec3(0, 0, 0.98 * exact), SurfaceRegion::wall},
      {Vec3(0, 0, 0.05e-3), 9e-9, Vec3(0, 0, 5 * exact), SurfaceRegion::wall},
      {Vec3(0, 0, 1.15e-3), 9e-9, Vec3(0, 0, 5 * exact), SurfaceRegion::wall}};
  const auto error = poiseuilleError(faces, 2 * vesselRadius, vesselLength, vesselConditions());
  EXPECT_NEAR(error.exact, exact, 1e-12);
  EXPECT_NEAR(error.mean, 0.01, 1e-12);
  EXPECT_NEAR(error.l2, 0.02, 1e-12);
  EXPECT_NEAR(error.largest, 0.02, 1e-12);
  EXPECT_EQ(error.endMargin, 0.1e-3);
}

TEST(PoiseuilleError, LeavesMoreOutOfAWiderTube) {
  const FlowConditions conditions = vesselConditions();
  EXPECT_DOUBLE_EQ(poiseuilleError({}, 20 * vesselRadius, 10 * vesselLength, conditions).endMargin, 1e-3);
  EXPECT_DOUBLE_EQ(poiseuilleError({}, 0.2 * vesselRadius, vesselLength, conditions).endMargin, 0.1e-3);
}

}  // namespace
}  // namespace restenosis

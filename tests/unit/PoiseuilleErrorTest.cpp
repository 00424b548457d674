#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "bridge/flow/PoiseuilleError.h"
#include "tests/support/Constants.h"
#include "tests/support/FlowSupport.h"

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
  ASSERT_TRUE(error);
  EXPECT_NEAR(error->exact, exact, 1e-12);
  EXPECT_NEAR(error->mean, 0.01, 1e-12);
  EXPECT_NEAR(error->l2, 0.02, 1e-12);
  EXPECT_NEAR(error->largest, 0.02, 1e-12);
  EXPECT_EQ(error->endMargin, 0.1e-3);
}

TEST(PoiseuilleError, IsNotKnownWhereThereIsNothingBetweenTheEnds) {
  const std::vector<WallFace> faces = {{Vec3(0, 0, 0.05e-3), 1e-9, Vec3(0, 0, 1), SurfaceRegion::wall}};
  EXPECT_FALSE(poiseuilleError(faces, 2 * vesselRadius, 0.1e-3, vesselConditions()));
}

TEST(PoiseuilleError, LeavesMoreOutOfAWiderTube) {
  const FlowConditions conditions = vesselConditions();
  const double middle = 0.5 * vesselLength;
  const std::vector<WallFace> faces = {{Vec3(0, 0, middle), 1e-9, Vec3(0, 0, 1), SurfaceRegion::wall}};
  EXPECT_DOUBLE_EQ(poiseuilleError(faces, 2.2 * vesselRadius, vesselLength, conditions)->endMargin, 0.11e-3);
  EXPECT_DOUBLE_EQ(poiseuilleError(faces, 0.2 * vesselRadius, vesselLength, conditions)->endMargin, 0.1e-3);
}

}  // namespace
}  // namespace restenosis

#include <gtest/gtest.h>

#include "tissue/vessel/Cylindrical.h"
#include "tissue/vessel/SurfaceFromAxis.h"

namespace restenosis {
namespace {

TEST(SurfaceFromAxis, OfACylinderIsExact) {
  const SurfaceFromAxis cylinder(0.9e-3);
  const Vec3 place(3e-4, -4e-4, 1e-4);
  EXPECT_TRUE(cylinder.isCylinder());
  EXPECT_EQ(cylinder.at(place), 0.9e-3);
  EXPECT_EQ(cylinder.normalAt(place), radialAt(place));
  EXPECT_NEAR(cylinder.areaElementAt(place), 0.9e-3, 1e-18);
  EXPECT_EQ(cylinder.least(), cylinder.greatest());
}

TEST(SurfaceFromAxis, OfAMapHasItsBounds) {
  // Two planes of eight nodes, the upper one wider
  std::vector<double> values(16, 1e-3);
  std::fill(values.begin() + 8, values.end(), 1.2e-3);
  const SurfaceFromAxis widening(RadiusMap(8, 0, 1e-3, values));
  EXPECT_FALSE(widening.isCylinder());
  EXPECT_EQ(widening.least(), 1e-3);
  EXPECT_EQ(widening.greatest(), 1.2e-3);
  const Vec3 half(0, 1, 0.5e-3);
  EXPECT_NEAR(widening.at(half), 1.1e-3, 1e-15);
  EXPECT_LT((widening.normalAt(half) - Vec3(0, 1, -0.2).normalized()).norm(), 1e-12);
}

}  // namespace
}  // namespace restenosis

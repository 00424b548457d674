#include <gtest/gtest.h>

#include "bridge/flow/foam/PlaceInEnd.h"
#include "tests/support/AnnularTube.h"

namespace restenosis {
namespace {

using namespace support;

TEST(PlaceInEnd, IsTheCentreOfARoundEnd) {
  const Vec3 place = placeInEnd(tube(0.9e-3, 1e-3), SurfaceRegion::outlet);
  EXPECT_NEAR((place - Vec3(0, 0, 1e-3)).norm(), 0.0, 1e-12);
}

TEST(PlaceInEnd, LiesBetweenTheRimsOfAnAnnulus) {
  for (const double aside : {0.0, 0.25e-3}) {
    const Vec3 place = placeInEnd(annularTube(0.9e-3, 0.6e-3, 1e-3, aside), SurfaceRegion::inlet);
    EXPECT_EQ(place.z(), 0.0);
    EXPECT_LT(place.norm(), 0.85e-3);
    EXPECT_GT((place - Vec3(aside, 0, 0)).norm(), 0.65e-3);
  }
}

TEST(PlaceInEnd, KeepsClearOfAHoleBesideTheCentre) {
  // The centroid lies in the end, 40 um from the hole
  const TriSurface lumen = annularTube(0.9e-3, 0.1e-3, 1e-3, 0.14e-3);
  EXPECT_GT((placeInEnd(lumen, SurfaceRegion::inlet) - Vec3(0.14e-3, 0, 0)).norm(), 0.25e-3);
}

}  // namespace
}  // namespace restenosis

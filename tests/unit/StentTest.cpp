#include <gtest/gtest.h>

#include "tissue/stent/Stent.h"
#include "tissue/vessel/Cylindrical.h"

namespace restenosis {
namespace {

StrutSegment boxStrut(bool round = false) {
  return {.a = {1e-3, 0, 0},
          .b = {1e-3, 0, 200e-6},
          .radial = Vec3::UnitX(),
          .width = 80e-6,
          .thickness = 60e-6,
          .round = round};
}

TEST(Stent, DistanceToABoxIsExact) {
  const StrutSegment segment = boxStrut();
  const Vec3 middle(1e-3, 0, 100e-6);
  EXPECT_NEAR(StrutDistance(segment)(middle), -30e-6, 1e-18);
  EXPECT_NEAR(StrutDistance(segment)(middle + Vec3(30e-6, 0, 0)), 0, 1e-18);
  EXPECT_NEAR(StrutDistance(segment)(middle + Vec3(0, 50e-6, 0)), 10e-6, 1e-18);
  EXPECT_NEAR(StrutDistance(segment)(middle + Vec3(0, 0, 150e-6)), 50e-6, 1e-18);
  EXPECT_NEAR(StrutDistance(segment)(middle + Vec3(33e-6, 44e-6, 100e-6)), 5e-6, 1e-18);
  EXPECT_NEAR(StrutDistance(segment)(middle + Vec3(32e-6, 42e-6, 101e-6)), 3e-6, 1e-18);
}

TEST(Stent, DistanceToARoundStrut) {
  StrutSegment segment = boxStrut(true);
  segment.width = segment.thickness;
  const Vec3 middle(1e-3, 0, 100e-6);
  EXPECT_NEAR(StrutDistance(segment)(middle), -30e-6, 1e-18);
  EXPECT_NEAR(StrutDistance(segment)(middle + Vec3(30e-6, 40e-6, 0)), 20e-6, 1e-18);
  EXPECT_NEAR(StrutDistance(segment)(middle + Vec3(33e-6, 0, 104e-6)), 5e-6, 1e-18);
  const StrutSegment elliptic = boxStrut(true);
  EXPECT_NEAR(StrutDistance(elliptic)(middle + Vec3(30e-6, 0, 0)), 0, 1e-18);
  EXPECT_NEAR(StrutDistance(elliptic)(middle + Vec3(0, 40e-6, 0)), 0, 1e-18);
  EXPECT_LT(StrutDistance(elliptic)(middle), 0);
}

TEST(Stent, ARoundPointIsASphere) {
  StrutSegment segment = boxStrut(true);
  segment.b = segment.a;
  segment.width = segment.thickness = 20e-6;
  EXPECT_NEAR(StrutDistance(segment)(segment.a + Vec3(0, 9e-6, 12e-6)), 5e-6, 1e-18);
}

TEST(Stent, MovesAlongTheRadiusWithItsSpheres) {
  Stent stent;
  stent.segments.push_back({.a = {1e-3, 0, 0},
                            .b = {0, 1e-3, 0},
                            .radial = Vec3(1, 1, 0).normalized(),
                            .width = 80e-6,
                            .thickness = 60e-6,
                            .round = false});
  stent.spheres.push_back({.segment = 0, .along = 0.25, .across = 20e-6, .outward = 10e-6, .radius = 5e-6});
  for (const double distance : {0.0, 50e-6}) {
    const Stent moved = stent.movedOutwards(distance);
    EXPECT_NEAR(radiusOf(moved.segments[0].a), 1e-3 + distance, 1e-15);
    const Cylindrical c = toCylindrical(moved.centre(0));
    EXPECT_NEAR(c.radius, 1.01e-3 + distance, 1e-15);
    EXPECT_NEAR(c.angle, std::numbers::pi / 8, 1e-12);
    EXPECT_NEAR(std::abs(c.z), 20e-6, 1e-15);
  }
}

}  // namespace
}  // namespace restenosis

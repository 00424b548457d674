#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/Constants.h"
#include "tissue/stent/StrutAgents.h"

namespace restenosis {
namespace {

using namespace support;

/// A strut 0.1 mm long and 60 um thick, with ends that are open or not.
StrutSegment shortStrut(bool open, double width = 60e-6) {
  return {.a = {1e-3, 0, 0},
          .b = {1e-3, 0, 0.1e-3},
          .radial = Vec3::UnitX(),
          .width = width,
          .thickness = 60e-6,
          .round = false,
          .openA = open,
          .openB = open};
}

TEST(StrutAgents, SpheresCoverTheSectionsBoundaryAndOpenEnds) {
  // 7 layers of 3 x 3 places, of which only open ends have the one in the middle
  EXPECT_EQ(coverWithSpheres({shortStrut(false)}, r).size(), 7 * 8u);
  const auto open = coverWithSpheres({shortStrut(true)}, r);
  EXPECT_EQ(open.size(), 7 * 8 + 2u);
  double first = 1, last = 0, across = 0, outward = 0;
  for (const StrutSphere& sphere : open) {
    EXPECT_EQ(sphere.radius, r);
    first = std::min(first, sphere.along), last = std::max(last, sphere.along);
    across = std::max(across, sphere.across), outward = std::max(outward, sphere.outward);
  }
  EXPECT_NEAR(first * 0.1e-3, r, 1e-15) << "flush with the end";
  EXPECT_NEAR((1 - last) * 0.1e-3, r, 1e-15);
  EXPECT_NEAR(across + r, 30e-6, 1e-15) << "flush with the sides";
  EXPECT_NEAR(outward + r, 30e-6, 1e-15);
}

TEST(StrutAgents, ARoundSectionIsARingOfSpheres) {
  StrutSegment round = shortStrut(false);
  round.round = true;
  const auto spheres = coverWithSpheres({round}, r);
  EXPECT_EQ(spheres.size(), 7 * 7u);  // 2 pi spheres around, rounded up
  for (const StrutSphere& sphere : spheres) EXPECT_NEAR(std::hypot(sphere.across, sphere.outward), r, 1e-15);
}

TEST(StrutAgents, SpheresAreNoThickerThanTheStrut) {
  const auto spheres = coverWithSpheres({shortStrut(false), shortStrut(false, 20e-6)}, r);
  EXPECT_TRUE(std::ranges::all_of(
      spheres, [](const StrutSphere& s) { return s.radius == (s.segment == 0 ? r : 10e-6); }));
  EXPECT_EQ(std::ranges::count(spheres, 1u, &StrutSphere::segment), 10 * 5) << "one across, five outward";
}

}  // namespace
}  // namespace restenosis

#include <gtest/gtest.h>

#include "tests/support/Constants.h"
#include "tissue/stent/StrutFootprint.h"
#include "tissue/vessel/Cylindrical.h"

namespace restenosis {
namespace {

using namespace support;

class StrutFootprintTest : public testing::Test {
 protected:
  /// A strut along the vessel at the angle 0 and one at a right angle to it, both from z = 0.1 to 0.3 mm.
  StrutFootprintTest() {
    for (const Vec3& out : {Vec3(1, 0, 0), Vec3(0, 1, 0)})
      stent.segments.push_back({.a = 1e-3 * out + Vec3(0, 0, 0.1e-3),
                                .b = 1e-3 * out + Vec3(0, 0, 0.3e-3),
                                .radial = out,
                                .width = 80e-6,
                                .thickness = 60e-6,
                                .round = false});
  }
  std::vector<StrutFootprint::Hit> hits(const Vec3& place, double margin = 0) const {
    std::vector<StrutFootprint::Hit> all;
    StrutFootprint(stent).visit(place, margin, [&](const StrutFootprint::Hit& hit) { all.push_back(hit); });
    return all;
  }
  Stent stent;
};

TEST_F(StrutFootprintTest, FindsTheStrutAtAnyDistanceFromTheAxis) {
  for (const double fromAxis : {0.5e-3, 1e-3, 2e-3}) {
    const auto found = hits(toCartesian({fromAxis, pi / 2 + 0.03, 0.2e-3}));
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].segment, 1u);
    EXPECT_NEAR(found[0].across, 1e-3 * std::sin(0.03), 1e-15);
    EXPECT_NEAR(found[0].outerFace, 1.03e-3, 1e-15);
  }
  EXPECT_TRUE(hits({-1e-3, 0, 0.2e-3}).empty()) << "the other side of the vessel";
}

TEST_F(StrutFootprintTest, EndsAtTheStrutsEdgesLessTheMargin) {
  const auto beside = [](double across) { return toCartesian({1e-3, std::asin(across / 1e-3), 0.2e-3}); };
  EXPECT_EQ(hits(beside(39.9e-6)).size(), 1u);
  EXPECT_TRUE(hits(beside(40.1e-6)).empty());
  EXPECT_EQ(hits(beside(-24.9e-6), 15e-6).size(), 1u);
  EXPECT_TRUE(hits(beside(-25.1e-6), 15e-6).empty());
  EXPECT_EQ(hits({1e-3, 0, 0.3e-3 - 1e-7}).size(), 1u);
  EXPECT_TRUE(hits({1e-3, 0, 0.3e-3 + 1e-7}).empty());
  stent.segments[0].overlap = 2e-7;
  EXPECT_EQ(hits({1e-3, 0, 0.3e-3 + 1e-7}).size(), 1u);
}

TEST_F(StrutFootprintTest, OfASphereIsItsWidth) {
  StrutSegment& sphere = stent.segments[0];
  sphere.b = sphere.a;
  sphere.round = true;
  EXPECT_EQ(hits({1e-3, 0, 0.1e-3 + 39e-6}).size(), 1u);
  EXPECT_TRUE(hits({1e-3, 0, 0.1e-3 + 41e-6}).empty());
  EXPECT_TRUE(hits({1e-3, 0, 0.1e-3 + 39e-6}, 5e-6).empty());
}

}  // namespace
}  // namespace restenosis

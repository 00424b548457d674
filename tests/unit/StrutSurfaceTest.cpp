#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <utility>

#include "bridge/surface/StrutSurface.h"
#include "bridge/surface/SurfaceCheck.h"

namespace restenosis {
namespace {

/// A bar along y, or with its ends beyond the vessel's along z.
StrutSegment bar(const Vec3& a, const Vec3& b) {
  return {.a = a, .b = b, .radial = Vec3::UnitX(), .width = 3, .thickness = 2, .round = false};
}

/// Whether every edge of a triangle is another's, the other way round.
bool closed(const TriSurface& surface) {
  std::multiset<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const auto& t : surface.triangles)
    for (int c = 0; c < 3; ++c) edges.emplace(t[c], t[(c + 1) % 3]);
  return std::ranges::all_of(edges, [&](const auto& e) {
    return edges.count(e) == 1 && edges.count({e.second, e.first}) == 1;
  });
}

TEST(StrutSurface, EnclosesTheStruts) {
  const std::vector<StrutSegment> two{bar({8, -4, 10}, {8, 4, 10}), bar({-8, -4, 14}, {-8, 4, 14})};
  for (const double resolution : {0.5, 0.25}) {
    const TriSurface s = strutSurface(two, 20, resolution);
    const SurfaceReport report = checkSurface(s, 20);
    EXPECT_TRUE(closed(s));
    EXPECT_EQ(report.components, 2U);
    EXPECT_EQ(report.areaOf(SurfaceRegion::wall), 0.0);
    // Bevelled edges, 52 long on each bar, take at most half a square of the grid's spacing
    EXPECT_NEAR(enclosedVolume(s), 2 * 8 * 3 * 2, 2 * 52 * resolution * resolution / 2);
    for (const Vec3& v : s.vertices) EXPECT_LT(std::abs(v.y()), 4 + 1e-6);
  }
}

TEST(StrutSurface, IsClosedWhereTheVesselEnds) {
  const TriSurface s = strutSurface(std::vector{bar({8, 0, -5}, {8, 0, 5})}, 20, 0.25);
  const auto [least, most] = std::ranges::minmax(s.vertices, {}, [](const Vec3& v) { return v.z(); });
  EXPECT_EQ(least.z(), 0.0);
  EXPECT_NEAR(most.z(), 5, 1e-3);
  EXPECT_NEAR(enclosedVolume(s), 5 * 3 * 2, 40 * 0.25 * 0.25 / 2) << "40 of edges, bevelled";
  EXPECT_TRUE(closed(s));
}

TEST(StrutSurface, IsEmptyWithoutStruts) { EXPECT_TRUE(strutSurface({}, 20, 1).triangles.empty()); }

TEST(StrutSurface, IsEmptyWhereTheyAreBeyondTheVessel) {
  EXPECT_TRUE(strutSurface(std::vector{bar({8, 0, 40}, {8, 0, 50})}, 20, 1).triangles.empty());
}

}  // namespace
}  // namespace restenosis

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "bridge/surface/SurfaceEnds.h"
#include "tests/support/TubeSurface.h"

namespace restenosis {
namespace {

using support::ProfilePoint;

/// Whether the open end of a vessel that widens from it at this angle to its axis is taken for a hole.
bool openEndIsHole(double degrees, double radius) {
  const double far = 1e-3 * std::tan(degrees * std::numbers::pi / 180);
  TriSurface s = support::revolve({{radius, 0.0}, {radius + far, 1e-3}});
  std::erase_if(s.triangles, [&](const auto& t) { return t[0] == 256; });  // the inlet's centre
  const SurfaceEdges edges = surfaceEdges(s);
  const auto rims = openRims(edges.open);
  EXPECT_EQ(rims.size(), 1u);
  return holesAmong(s, edges, rims).at(0);
}

TEST(SurfaceEnds, RimsThatTouchAreToldApart) {
  const std::vector<OpenEdge> twoRims{{0, 1}, {1, 2}, {2, 0}, {2, 3}, {3, 4}, {4, 2}, {7, 8}, {8, 9}, {9, 7}};
  const auto rims = openRims(twoRims);
  ASSERT_EQ(rims.size(), 3u);
  std::size_t vertices = 0;
  for (const auto& rim : rims) vertices += rim.size();
  EXPECT_EQ(vertices, twoRims.size());
  EXPECT_THROW(openRims({{0, 1}, {1, 2}}), std::runtime_error);
}

TEST(SurfaceEnds, AnOpenEndMayBeTaperedAndNarrow) {
  for (const double radius : {1e-3, 1e-5}) {
    for (const double degrees : {-0.2, 0.0, 30.0, 59.0}) EXPECT_FALSE(openEndIsHole(degrees, radius));
    for (const double degrees : {61.0, 80.0, 89.0}) EXPECT_TRUE(openEndIsHole(degrees, radius));
  }
}

TEST(SurfaceEnds, AnOpenEndMayBeRough) {
  TriSurface s = support::tube(1e-3, 2e-3);
  for (std::size_t v = 0; v + 2 < s.vertices.size(); ++v) {
    s.vertices[v].head<2>() *= 1.0 + 0.05 * std::sin(37.0 * static_cast<double>(v * v));
    if (v < 128 && v % 2 == 0) s.vertices[v].z() = 0.03e-3;  // a rim of teeth
  }
  std::erase_if(s.triangles, [&](const auto& t) { return t[0] == s.vertices.size() - 2; });
  const SurfaceEdges edges = surfaceEdges(s);
  EXPECT_EQ(holesAmong(s, edges, openRims(edges.open)), std::vector<bool>{false});
}

TEST(SurfaceEnds, ACrackIsAHole) {
  TriSurface s = support::tube(1e-3, 2e-3);
  const Vec3 beside = 0.5 * (s.vertices[128] + s.vertices[256]);  // on an edge along the tube, of one side
  const auto added = static_cast<std::uint32_t>(s.vertices.size());
  s.vertices.push_back(beside);
  for (auto& t : s.triangles)
    if (t == std::array<std::uint32_t, 3>{128, 257, 256}) {
      t = {128, 257, added};
      s.triangles.push_back({added, 257, 256});
      break;
    }
  const SurfaceEdges edges = surfaceEdges(s);
  const auto rims = openRims(edges.open);
  ASSERT_EQ(rims.size(), 1u);
  EXPECT_EQ(rims[0].size(), 3u);
  EXPECT_TRUE(holesAmong(s, edges, rims).at(0));
}

}  // namespace
}  // namespace restenosis

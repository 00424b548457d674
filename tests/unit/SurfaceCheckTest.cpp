#include <gtest/gtest.h>

#include <limits>

#include "bridge/surface/CylinderSurface.h"
#include "bridge/surface/SurfaceCheck.h"

namespace restenosis {
namespace {

struct SurfaceCheck : testing::Test {
  VesselParameters vessel;
  TriSurface surface;
  SurfaceCheck() {
    vessel.length = 1e-3;
    surface = cylinderSurface(vessel, {100e-6, 100e-6});
  }
  std::string verdict() const { return checkSurface(surface, vessel.length).summary(); }
  bool says(const char* text) const { return verdict().find(text) != std::string::npos; }
};

TEST_F(SurfaceCheck, AcceptsAGoodSurface) { EXPECT_EQ(verdict(), ""); }

TEST_F(SurfaceCheck, FindsAHole) {
  surface.triangles.pop_back();
  surface.region.pop_back();
  EXPECT_TRUE(says("hole")) << verdict();
}

TEST_F(SurfaceCheck, FindsATriangleTurnedOver) {
  std::swap(surface.triangles[0][0], surface.triangles[0][1]);
  EXPECT_TRUE(says("opposite orientation")) << verdict();
}

TEST_F(SurfaceCheck, FindsADoubledTriangle) {
  surface.triangles.push_back(surface.triangles[0]);
  surface.region.push_back(SurfaceRegion::wall);
  EXPECT_TRUE(says("more than two")) << verdict();
}

TEST_F(SurfaceCheck, FindsASurfaceInsideOut) {
  for (auto& t : surface.triangles) std::swap(t[0], t[1]);
  EXPECT_TRUE(says("oriented outwards")) << verdict();
}

TEST_F(SurfaceCheck, FindsNaN) {
  surface.vertices[3].x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(says("not finite")) << verdict();
}

TEST_F(SurfaceCheck, FindsADegenerateTriangle) {
  surface.vertices[surface.triangles[0][0]] = surface.vertices[surface.triangles[0][1]];
  EXPECT_TRUE(says("degenerate")) << verdict();
}

TEST_F(SurfaceCheck, FindsABentEnd) {
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    if (surface.region[t] == SurfaceRegion::outlet) {
      surface.vertices[surface.triangles[t][0]].z() -= 1e-6;
      break;
    }
  EXPECT_TRUE(says("outlet is not planar")) << verdict();
}

TEST_F(SurfaceCheck, FindsAMissingEndAndAnotherLumen) {
  for (auto& r : surface.region)
    if (r == SurfaceRegion::inlet) r = SurfaceRegion::wall;
  const auto vertices = static_cast<std::uint32_t>(surface.vertices.size());
  const std::size_t triangles = surface.triangles.size();
  for (std::uint32_t v = 0; v < vertices; ++v)
    surface.vertices.push_back(surface.vertices[v] + Vec3(1, 0, 0));
  for (std::size_t t = 0; t < triangles; ++t) {
    auto c = surface.triangles[t];
    for (auto& v : c) v += vertices;
    surface.triangles.push_back(c);
    surface.region.push_back(surface.region[t]);
  }
  EXPECT_TRUE(says("inlet has no area")) << verdict();
  EXPECT_TRUE(says("2 separate lumens")) << verdict();
}

TEST_F(SurfaceCheck, FindsBadIndicesAndEmptiness) {
  surface.triangles[0][0] = 1U << 30;
  EXPECT_TRUE(says("does not exist"));
  surface = {};
  EXPECT_TRUE(says("empty"));
}

}  // namespace
}  // namespace restenosis

#include <gtest/gtest.h>

#include <cmath>

#include "bridge/surface/Isosurface.h"
#include "bridge/surface/LumenSurface.h"
#include "bridge/surface/SurfaceCheck.h"
#include "tests/support/Constants.h"
#include "tests/support/SphereWall.h"

namespace restenosis {
namespace {

using namespace support;

TEST(LumenSurface, IsClosedWithPlanarEnds) {
  const double length = 307 * um;
  const TriSurface s =
      extractSurface(LumenField::fromTissue(sphereWall(150 * um, length, 15 * um), {}, length));
  const SurfaceReport report = checkSurface(s, length);
  EXPECT_TRUE(report.good()) << report.summary();
  EXPECT_EQ(report.components, 1U);
  EXPECT_EQ(report.areaOf(SurfaceRegion::strut), 0.0);
  for (std::size_t t = 0; t < s.triangles.size(); ++t) {
    const double z = s.centre(t).z();
    if (s.region[t] == SurfaceRegion::inlet) {
      EXPECT_EQ(z, 0.0);
    }
    if (s.region[t] == SurfaceRegion::wall) {
      EXPECT_GT(z, 0.0);
      EXPECT_LT(z, length);
    }
  }
}

TEST(LumenSurface, RefusesAnOccludedLumen) {
  const auto field =
      LumenField::fromFunction([](const Vec3& p) { return std::abs(p.z() - 5) - 2; }, 10, 5, 1);
  EXPECT_THROW(extractSurface(field), Occluded);
}

TEST(LumenSurface, RelaxationRemovesSliversAndKeepsTheShape) {
  const double radius = 5.0, length = 10;  // passes through nodes: slivers
  const auto field = LumenField::fromFunction(
      [&](const Vec3& p) { return radius - std::hypot(p.x(), p.y()); }, length, 7, 0.5);
  auto worst = [](const TriSurface& s) {
    double least = 1;
    for (std::size_t t = 0; t < s.triangles.size(); ++t) {
      if (s.region[t] != SurfaceRegion::wall) continue;
      double longest = 0;
      for (int c = 0; c < 3; ++c)
        longest = std::max(
            longest, (s.vertices[s.triangles[t][c]] - s.vertices[s.triangles[t][(c + 1) % 3]]).squaredNorm());
      least = std::min(least, 2 * s.areaVector(t).norm() / longest);
    }
    return least;
  };
  const TriSurface raw = isosurface(field.lumen(), {.relaxations = 0}), relaxed = extractSurface(field);
  EXPECT_LT(worst(raw), 0.05);
  EXPECT_GT(worst(relaxed), 0.2);
  EXPECT_NEAR(checkSurface(relaxed, length).volume, checkSurface(raw, length).volume,
              2e-3 * checkSurface(raw, length).volume);
}

}  // namespace
}  // namespace restenosis

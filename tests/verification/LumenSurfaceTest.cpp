#include <gtest/gtest.h>
#include <omp.h>

#include <cmath>
#include <numbers>

#include "bridge/surface/LumenSurface.h"
#include "bridge/surface/RadialMap.h"
#include "bridge/surface/SurfaceCheck.h"
#include "tests/support/Constants.h"
#include "tests/support/SphereWall.h"
#include "tissue/stent/StentDesign.h"
#include "tissue/vessel/WallPacking.h"

namespace restenosis {
namespace {

using namespace support;

TEST(LumenSurfaceVerification, SmoothLumenConvergesWithSecondOrder) {
  const double radius = 1, amplitude = 0.2, length = 2;
  auto lumen = [&](const Vec3& p) {
    return radius - amplitude * (1 - std::cos(pi * p.z())) / 2 - std::hypot(p.x(), p.y());
  };
  // Integral of pi (0.9 + 0.1 cos)^2 over one period.
  const double exact = pi * length * (0.9 * 0.9 + 0.5 * 0.1 * 0.1);
  std::vector<double> error, mapError;
  for (const double h : {0.1, 0.05, 0.025}) {
    const auto field = LumenField::fromFunction(lumen, length, 1.2, h);
    error.push_back(std::abs(checkSurface(extractSurface(field), length).volume - exact) / exact);
    const RadialMap map(field);
    double volume = 0;
    for (int k = 0; k < map.planes(); ++k) volume += map.planeWeight(k) * map.lumenArea(k);
    mapError.push_back(std::abs(volume - exact) / exact);
  }
  EXPECT_LT(error[2], 1e-3);
  EXPECT_GT(std::log2(error[0] / error[1]), 1.7);
  EXPECT_GT(std::log2(error[1] / error[2]), 1.7);
  EXPECT_GT(std::log2(mapError[0] / mapError[1]), 1.7);
  EXPECT_GT(std::log2(mapError[1] / mapError[2]), 1.7);
}

TEST(LumenSurfaceVerification, AScatteredWallHasTheRadiusOfItsInnerFaces) {
  VesselParameters vessel;
  vessel.length = 0.3e-3;
  const Wall wall = scatterWall(vessel, cylindricalShape(vessel), 1);
  // The inner faces of the IEL touch R = 900 um; between the cells the ball reaches 2 to 4 um deeper.
  std::vector<double> radius;
  for (const double h : {20 * um, 15 * um, 10 * um}) {
    const LumenField field = LumenField::fromTissue(wall.agents, {}, vessel.length, {.resolution = h});
    radius.push_back(RadialMap(field).meanRadius());
    const SurfaceReport report = checkSurface(extractSurface(field), vessel.length);
    EXPECT_TRUE(report.good()) << report.summary();
    EXPECT_NEAR(report.volume, pi * radius.back() * radius.back() * vessel.length, 1e-3 * report.volume);
    EXPECT_NEAR(report.areaOf(SurfaceRegion::wall), 2 * pi * radius.back() * vessel.length,
                0.01 * report.areaOf(SurfaceRegion::wall));
  }
  for (const double r : radius) EXPECT_NEAR(r, 900 * um, 4 * um);
  EXPECT_LT(std::abs(radius[2] - radius[1]), 1 * um);
}

TEST(LumenSurfaceVerification, NoisyWallsWithDetachedCellsAreWatertight) {
  const double length = 0.3e-3;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    AgentStore wall = sphereWall(200 * um, length, 15 * um, 2, 12 * um, seed);
    RandomStream random(seed, 0, 0, RandomPurpose::packing);
    for (int n = 0; n < 12; ++n)
      wall.append(AgentKind::smc,
                  190 * um * std::sqrt(random.uniform()) * Vec3(random.direction()) + Vec3(0, 0, 150 * um),
                  15 * um);
    for (const double smoothing : {0.0, 15 * um, 30 * um}) {
      const LumenField field = LumenField::fromTissue(wall, {}, length, {.smoothing = smoothing});
      ASSERT_FALSE(field.occluded());
      const SurfaceReport report = checkSurface(extractSurface(field), length);
      EXPECT_TRUE(report.good()) << "seed " << seed << ": " << report.summary();
      EXPECT_EQ(report.components, 1U);
    }
  }
}

/// A ring strut of square section, its centreline at `radius`.
std::vector<StrutSegment> ring(double radius, double z, double width) {
  std::vector<StrutSegment> segments;
  const int count = 72;
  for (int n = 0; n < count; ++n) {
    auto at = [&](int m) {
      const double angle = 2 * pi * m / count;
      return Vec3(radius * std::cos(angle), radius * std::sin(angle), z);
    };
    const Vec3 a = at(n), b = at(n + 1), middle = 0.5 * (a + b);
    segments.push_back({.a = a,
                        .b = b,
                        .radial = Vec3(middle.x(), middle.y(), 0).normalized(),
                        .width = width,
                        .thickness = width,
                        .round = false,
                        .overlap = 0.5 * width * std::tan(pi / count) * 2,
                        .openA = false,
                        .openB = false});
  }
  return segments;
}

TEST(LumenSurfaceVerification, StrutsInTheWallAndInTheFlow) {
  const double length = 0.4e-3, width = 90 * um;
  const AgentStore wall = sphereWall(300 * um, length, 15 * um, 2, 4 * um);
  struct {
    double radius;
    std::size_t components;
  } const cases[] = {{290 * um, 1U}, {255 * um, 1U}, {150 * um, 2U}};
  for (const auto& c : cases) {
    const auto struts = ring(c.radius, 0.5 * length, width);
    const LumenField field = LumenField::fromTissue(wall, struts, length, {.resolution = 10 * um});
    const SurfaceReport report = checkSurface(extractSurface(field), length);
    EXPECT_TRUE(report.good()) << c.radius << ": " << report.summary();
    EXPECT_EQ(report.components, c.components) << c.radius;
    EXPECT_EQ(field.topology().floatingStruts, c.components - 1);
    EXPECT_GT(report.areaOf(SurfaceRegion::strut), 0.8 * 2 * pi * (c.radius - 45 * um) * width);
    // The inner face is exact, not smoothed.
    EXPECT_NEAR(RadialMap(field).radius((field.grid().nz - 1) / 2, 0), c.radius - 45 * um, 1 * um);
  }
  // Around a floating strut: its surface is that of a square torus.
  const LumenField field =
      LumenField::fromTissue(wall, ring(150 * um, 0.5 * length, width), length, {.resolution = 10 * um});
  const double torus = 2 * pi * 150 * um * 4 * width;
  EXPECT_NEAR(checkSurface(extractSurface(field), length).areaOf(SurfaceRegion::strut), torus, 0.05 * torus);
}

TEST(LumenSurfaceVerification, DoesNotDependOnThreads) {
  const double length = 0.3e-3;
  const AgentStore wall = sphereWall(200 * um, length, 15 * um, 2, 8 * um);
  const auto struts = ring(180 * um, 0.5 * length, 60 * um);
  auto make = [&](int threads) {
    const int before = omp_get_max_threads();
    omp_set_num_threads(threads);
    const LumenField field = LumenField::fromTissue(wall, struts, length);
    auto result = std::pair(extractSurface(field), RadialMap(field));
    omp_set_num_threads(before);
    return result;
  };
  const auto one = make(1), three = make(3);
  EXPECT_EQ(one.first.vertices, three.first.vertices);
  EXPECT_EQ(one.first.triangles, three.first.triangles);
  EXPECT_EQ(one.first.region, three.first.region);
  EXPECT_EQ(displacement(one.second, three.second).largest, 0.0);
}

TEST(LumenSurfaceVerification, EndsDoNotFlare) {
  const double length = 0.6e-3;
  const RadialMap map(LumenField::fromTissue(sphereWall(300 * um, length, 15 * um), {}, length));
  double mean = map.meanRadius();
  for (const int k : {0, 1, map.planes() - 2, map.planes() - 1})
    EXPECT_NEAR(std::sqrt(map.lumenArea(k) / pi), mean, 1.5 * um) << k;
}

}  // namespace
}  // namespace restenosis

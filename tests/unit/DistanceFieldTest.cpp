#include <gtest/gtest.h>
#include <omp.h>

#include <cmath>

#include "bridge/surface/BandField.h"
#include "bridge/surface/DistanceField.h"
#include "tests/support/Constants.h"
#include "tests/support/SphereWall.h"

namespace restenosis {
namespace {

using namespace support;

TEST(DistanceField, IsTheDistanceToTheNearestSphere) {
  const LumenGrid g(200 * um, 100 * um, 10 * um);
  const std::vector<Ball> balls{{{10 * um, 0, 100 * um}, 15 * um}, {{-40 * um, 20 * um, 90 * um}, 20 * um}};
  const GridField d = sphereDistance(g, balls, 30 * um);
  for (int k = 0; k < g.nz; ++k)
    for (int j = 0; j < g.ny; ++j)
      for (int i = 0; i < g.nx; ++i) {
        double expected = 30 * um;
        for (const Ball& b : balls)
          expected = std::min(expected, (g.node(i, j, k) - b.centre).norm() - b.radius);
        ASSERT_NEAR(d.values[g.index(i, j, k)], expected, 1e-4 * um);
      }
}

TEST(DistanceField, MirrorsSpheresAtTheEnds) {
  const LumenGrid g(100 * um, 50 * um, 10 * um);
  const std::vector<Ball> balls{{{0, 0, -15 * um}, 10 * um}};
  // The sphere itself is 5 um beyond the end; its image is inside.
  EXPECT_NEAR(BandField(sphereDistance(g, balls, 30 * um)).at({0, 0, 20 * um}), -5 * um, 1e-3 * um);
}

TEST(DistanceField, ClosingFillsWhatTheBallCannotEnterAndShavesNothingOff) {
  const LumenGrid g(400 * um, 200 * um, 5 * um);
  // Two rows of spheres along y, a slit 30 um wide between them: a ball of radius 30 does not pass.
  std::vector<Ball> balls;
  for (int n = -40; n <= 40; ++n)
    for (int m = 0; m <= 80; ++m)
      for (const double x : {-30 * um, 30 * um}) balls.push_back({{x, n * 5 * um, m * 5 * um}, 15 * um});
  const double probe = 30 * um;
  GridField closed = sphereDistance(g, balls, probe + 5 * um);
  closeByBall(closed, probe, 15 * um);
  EXPECT_LT(BandField(closed).at({0, 0, 200 * um}), 0);
  // Outer faces stay at 45 um; the bound is the depth of the scallops.
  EXPECT_NEAR(BandField(closed).at({50 * um, 0, 200 * um}), 5 * um, 0.5 * um);
  GridField open = sphereDistance(g, balls, 15 * um);
  closeByBall(open, 10 * um, 15 * um);
  EXPECT_GT(BandField(open).at({0, 0, 200 * um}), 0);
}

TEST(DistanceField, BlurKeepsPlanesAndConstants) {
  const LumenGrid g(300 * um, 150 * um, 15 * um);
  GridField field(g, 0);
  for (int k = 0; k < g.nz; ++k)
    for (int j = 0; j < g.ny; ++j)
      for (int i = 0; i < g.nx; ++i) field.values[g.index(i, j, k)] = static_cast<float>(g.x(i) + 2 * g.y(j));
  blur(field, 20 * um);
  EXPECT_NEAR(BandField(field).at({15 * um, 0, 0}), 15 * um, 1e-3 * um);
  EXPECT_NEAR(BandField(field).at({0, 30 * um, 300 * um}), 60 * um, 1e-3 * um);
}

TEST(DistanceField, RoundedUnionIsTheMinimumAwayFromTheJoint) {
  const LumenGrid g(2, 1, 1);
  auto unite = [&](float a, float b) {
    GridField first(g, a);
    uniteRounded(first, BandField(GridField(g, b)), 4.0);
    return first.values[0];
  };
  EXPECT_EQ(unite(1, 6), 1);
  EXPECT_EQ(unite(9, -2), -2);
  EXPECT_FLOAT_EQ(unite(1, 1), 0);  // a quarter of the width below: a slit of half the width closes
}

TEST(DistanceField, OfFewSpheresIsTheSameWhereOnlyABandIsKept) {
  const LumenGrid g(400 * um, 200 * um, 10 * um);
  const std::vector<Ball> balls{{{0, 0, 100 * um}, 25 * um}, {{150 * um, 20 * um, 380 * um}, 15 * um}};
  const GridField whole = sphereDistance(g, balls, 30 * um);
  const BandField band = sphereBand(g, balls, 30 * um);
  for (int k = 0; k < g.nz; ++k)
    for (int j = 0; j < g.ny; ++j)
      for (int i = 0; i < g.nx; ++i) ASSERT_EQ(band(i, j, k), whole.values[g.index(i, j, k)]);
  EXPECT_LT(band.kept(), g.size() / 4);
}

TEST(DistanceField, DoesNotDependOnThreads) {
  const AgentStore wall = sphereWall(100 * um, 200 * um, 15 * um, 2, 5 * um);
  std::vector<Ball> balls;
  for (Index i = 0; i < wall.size(); ++i) balls.push_back({wall.position(i), wall.radius[i]});
  const LumenGrid g(200 * um, 170 * um, 10 * um);
  auto compute = [&](int threads) {
    const int before = omp_get_max_threads();
    omp_set_num_threads(threads);
    GridField f = sphereDistance(g, balls, 40 * um);
    closeByBall(f, 30 * um, 30 * um);
    blur(f, 15 * um);
    omp_set_num_threads(before);
    return f.values;
  };
  EXPECT_EQ(compute(1), compute(3));
}

}  // namespace
}  // namespace restenosis

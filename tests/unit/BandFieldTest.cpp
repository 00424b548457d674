#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "bridge/surface/BandField.h"

namespace restenosis {
namespace {

template <class F>
GridField fieldOf(const LumenGrid& g, const F& f) {
  GridField field(g, 0);
  for (int k = 0; k < g.nz; ++k)
    for (int j = 0; j < g.ny; ++j)
      for (int i = 0; i < g.nx; ++i) field.values[g.index(i, j, k)] = static_cast<float>(f(g.node(i, j, k)));
  return field;
}

/// The distance to a cylinder of radius 10 whose axis is off the grid's, clipped at 3.
double clippedDistance(const Vec3& p) { return std::clamp(10 - std::hypot(p.x() - 0.3, p.y()), -3.0, 3.0); }

TEST(BandField, InterpolatesTrilinearFunctionsExactly) {
  const LumenGrid g(1.0, 1.0, 0.25);
  auto f = [](const Vec3& p) { return 1 + 2 * p.x() - p.y() + 3 * p.z() + 0.5 * p.x() * p.y() * p.z(); };
  const BandField field(fieldOf(g, f));
  const Vec3 p(0.1, -0.3, 0.6);
  Vec3 gradient;
  // Within a cell the interpolant of x y z is exact.
  EXPECT_NEAR(field.at(p, gradient), f(p), 1e-6);
  EXPECT_NEAR(gradient.x(), 2 + 0.5 * p.y() * p.z(), 1e-5);
  EXPECT_NEAR(gradient.y(), -1 + 0.5 * p.x() * p.z(), 1e-5);
  EXPECT_NEAR(gradient.z(), 3 + 0.5 * p.x() * p.y(), 1e-5);
  EXPECT_NEAR(field.inPlane(0.1, -0.3, 2), f({0.1, -0.3, g.z(2)}), 1e-6);
}

TEST(BandField, IsThatOfTheAxisWithinTheEvenRadius) {
  for (const LumenGrid& g : {LumenGrid(20, 20, 1), LumenGrid(20, 23, 1)}) {
    const BandField field(
        fieldOf(g, [](const Vec3& p) { return clippedDistance(p) - (p.z() > 15 && p.x() < -2); }));
    for (int k = 0; k < g.nz; ++k) {
      const double even = field.evenRadius(k), onAxis = field.inPlane(0, 0, k);
      EXPECT_LT(even, 7.0) << "three within the cylinder's wall the distance is clipped no more";
      for (double r = 0; r < even; r += 0.1)
        for (double angle = 0; angle < 6.28; angle += 0.1)
          ASSERT_EQ(field.inPlane(r * std::cos(angle), r * std::sin(angle), k), onAxis) << k << ' ' << r;
    }
  }
  const LumenGrid small(4, 4, 1);
  EXPECT_EQ(BandField(fieldOf(small, [](const Vec3& p) { return p.x(); })).evenRadius(0), 0);
}

TEST(BandField, HasTheValuesOfTheWholeFieldAtEveryNode) {
  // Sides that are a whole number of blocks, and others
  for (const LumenGrid& g : {LumenGrid(40, 20, 1), LumenGrid(21, 22, 1)}) {
    const GridField whole = fieldOf(g, clippedDistance);
    const BandField field(whole);
    std::vector<float> row(g.nx);
    for (int k = 0; k < g.nz; ++k)
      for (int j = 0; j < g.ny; ++j) {
        field.copyRow(j, k, row.data());
        for (int i = 0; i < g.nx; ++i) {
          ASSERT_EQ(field(i, j, k), whole.values[g.index(i, j, k)]);
          ASSERT_EQ(row[i], field(i, j, k));
          ASSERT_NEAR(field.at(g.node(i, j, k)), row[i], 1e-6);
          ASSERT_NEAR(field.inPlane(g.x(i), g.y(j), k), row[i], 1e-6);
        }
      }
  }
}

TEST(BandField, KeepsOnlyBlocksThatAreNotEven) {
  const LumenGrid g(40, 40, 1);
  EXPECT_EQ(BandField(GridField(g, 2)).kept(), 0U);
  EXPECT_EQ(BandField(GridField(g, 2)).at({1.5, 2.5, 3.5}), 2);
  GridField oneNode(g, 2);
  oneNode.values[g.index(12, 12, 12)] = 1;  // within a block
  const BandField one(oneNode);
  oneNode.values[g.index(16, 12, 12)] = 1;  // between two
  const BandField two(oneNode);
  EXPECT_GT(one.kept(), 0U);
  EXPECT_EQ(two.kept(), 2 * one.kept());
  const BandField cylinder(fieldOf(g, clippedDistance));
  EXPECT_LT(cylinder.kept(), g.size() / 2);
}

TEST(BandField, BeyondTheGridIsAsOnIt) {
  const LumenGrid g(21, 22, 1);
  const BandField field(fieldOf(g, clippedDistance));
  EXPECT_EQ(field.at({9, 1, -5}), field.at({9, 1, 0}));
  EXPECT_EQ(field.at({9, 1, 50}), field.at({9, 1, 21}));
  EXPECT_EQ(field.at({-90, 1, 3}), -3);
}

TEST(BandField, MayBeKeptOnlyWhereAnotherIsNotEven) {
  const LumenGrid g(40, 40, 1);
  GridField spot(g, 2);
  spot.values[g.index(30, 40, 20)] = 1;
  const BandField near(spot);
  const GridField whole = fieldOf(g, [](const Vec3& p) { return p.x(); });
  const BandField field(whole, near);
  EXPECT_EQ(field.kept(), near.kept());
  EXPECT_FALSE(near.evenAround(g.node(30, 40, 20)));
  EXPECT_TRUE(near.evenAround(g.node(50, 40, 20)));
  EXPECT_EQ(field(30, 41, 20), whole.values[g.index(30, 41, 20)]);
}

}  // namespace
}  // namespace restenosis

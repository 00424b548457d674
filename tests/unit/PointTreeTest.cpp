#include <gtest/gtest.h>

#include <algorithm>

#include "bridge/surface/PointTree.h"
#include "tissue/agents/RandomStream.h"

namespace restenosis {
namespace {

std::vector<Vec3> scatteredPoints() {
  std::vector<Vec3> points;
  for (std::uint64_t n = 0; n < 500; ++n) {
    RandomStream random(1, n, 0, RandomPurpose::packing);
    points.emplace_back(random.uniform(), random.uniform(), random.uniform());
  }
  return points;
}

TEST(PointTree, FindsTheNearestInTheirOrder) {
  const auto points = scatteredPoints();
  const PointTree tree(points);
  const Vec3 place(0.3, 0.6, 0.2);
  std::vector<double> distances;
  for (const Vec3& p : points) distances.push_back((p - place).norm());
  std::ranges::sort(distances);
  const auto found = tree.nearest(place, 7);
  ASSERT_EQ(found.size(), 7u);
  for (std::size_t n = 0; n < found.size(); ++n) {
    EXPECT_DOUBLE_EQ(found[n].distance, distances[n]);
    EXPECT_DOUBLE_EQ(found[n].distance, (points[found[n].index] - place).norm());
  }
}

TEST(PointTree, FindsAllWithinADistance) {
  const auto points = scatteredPoints();
  const PointTree tree(points);
  const Vec3 place(0.5, 0.5, 0.5);
  std::vector<std::size_t> expected, found;
  for (std::size_t n = 0; n < points.size(); ++n)
    if ((points[n] - place).norm() < 0.3) expected.push_back(n);
  for (const auto& near : tree.within(place, 0.3)) {
    found.push_back(near.index);
    EXPECT_DOUBLE_EQ(near.distance, (points[near.index] - place).norm());
  }
  std::ranges::sort(found);
  EXPECT_EQ(found, expected);
  EXPECT_GT(found.size(), 10u);
}

TEST(PointTree, HasNoMoreThanItWasGiven) {
  const PointTree none({}), one({Vec3(1, 0, 0)});
  EXPECT_TRUE(none.empty());
  EXPECT_TRUE(none.nearest(Vec3::Zero(), 3).empty());
  EXPECT_TRUE(none.within(Vec3::Zero(), 3).empty());
  EXPECT_EQ(one.nearest(Vec3::Zero(), 3).size(), 1u);
}

}  // namespace
}  // namespace restenosis

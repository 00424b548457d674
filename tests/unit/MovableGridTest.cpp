#include <gtest/gtest.h>

#include <set>
#include <stdexcept>

#include "tissue/agents/RandomStream.h"
#include "tissue/neighbours/MovableGrid.h"

namespace restenosis {
namespace {

/// All points within `distance` of each point are candidates, and none twice.
void expectComplete(const MovableGrid& grid, const std::vector<Vec3>& points, double distance) {
  for (const Vec3& point : points) {
    std::multiset<Index> candidates;
    grid.forEachCandidate(point, distance, [&](Index j) { candidates.insert(j); });
    for (Index j = 0; j < points.size(); ++j) {
      ASSERT_LE(candidates.count(j), 1u);
      if ((point - points[j]).norm() <= distance) {
        ASSERT_EQ(candidates.count(j), 1u) << j;
      }
    }
  }
}

/// Moves or adds these points.
void follow(MovableGrid& grid, const std::vector<Index>& changed, const std::vector<Vec3>& points) {
  for (const Index i : changed) i < grid.size() ? grid.move(i, points[i]) : grid.add(points[i]);
}

Vec3 noPoint(std::size_t) { return Vec3::Zero(); }

TEST(MovableGrid, FollowsPointsThatMoveAndCome) {
  RandomStream random(3, 0, 0, RandomPurpose::packing);
  const auto anywhere = [&] { return Vec3(random.uniform(), random.uniform(), random.uniform()); };
  std::vector<Vec3> points(200);
  for (Vec3& point : points) point = anywhere();
  MovableGrid grid(
      points.size(), [&](std::size_t k) { return points[k]; }, 0.1);
  expectComplete(grid, points, 0.12);
  for (int step = 0; step < 5; ++step) {
    std::vector<Index> moved;
    for (std::size_t i = 0; i < points.size(); i += 3) {
      points[i] = i % 2 == 0 ? anywhere() : Vec3(points[i] + 3 * anywhere());  // some leave the box
      moved.push_back(static_cast<Index>(i));
    }
    for (int n = 0; n < 2; ++n) {
      moved.push_back(static_cast<Index>(points.size()));
      points.push_back(anywhere());
    }
    follow(grid, moved, points);
    ASSERT_EQ(grid.size(), points.size());
    for (const double distance : {0.01, 0.12, 0.5}) expectComplete(grid, points, distance);
  }
}

TEST(MovableGrid, TellsWhetherAnyCandidateIsWanted) {
  MovableGrid grid(Vec3::Zero(), Vec3::Ones(), 100, 0.1);
  for (const double x : {0.05, 0.08, 0.45}) grid.add({x, 0.05, 0.05});
  const Vec3 place(0.05, 0.05, 0.05);
  const auto any = [&](Index wanted) {
    return grid.anyCandidate(place, 0.1, [&](Index j) { return j == wanted; });
  };
  EXPECT_TRUE(any(0));
  EXPECT_TRUE(any(1));
  EXPECT_FALSE(any(2)) << "it is four cells away";
  grid.move(2, {0.14, 0.05, 0.05});
  EXPECT_TRUE(any(2));
}

TEST(MovableGrid, FindsPointsHoweverFarFromAllOthers) {
  RandomStream random(4, 0, 0, RandomPurpose::packing);
  std::vector<Vec3> points(200);
  for (Vec3& point : points) point = Vec3(random.uniform(), random.uniform(), random.uniform());
  for (const double x : {30.0, -1e7, 1e12, 1e200}) {
    points.emplace_back(x, -x, 2 * x);
    points.emplace_back(x + 0.05, -x, 2 * x);
  }
  MovableGrid grid(
      points.size(), [&](std::size_t k) { return points[k]; }, 0.1);
  for (const double distance : {0.01, 0.12, 1e3}) expectComplete(grid, points, distance);
  std::vector<Index> last;
  for (auto i = static_cast<Index>(points.size() - 8); i < points.size(); ++i) {
    points[i] += Vec3(0.01, 0.2, 0);
    last.push_back(i);
  }
  follow(grid, last, points);
  for (const double distance : {0.01, 0.12, 1e3}) expectComplete(grid, points, distance);
}

TEST(MovableGrid, BeginsWithoutPoints) {
  MovableGrid grid(0, noPoint, 0.1);
  grid.add({5, 5, 5});
  int found = 0;
  grid.forEachCandidate(Vec3(5, 5, 5.05), 0.1, [&](Index) { ++found; });
  EXPECT_EQ(found, 1);
  EXPECT_THROW(MovableGrid(0, noPoint, 0), std::invalid_argument);
}

}  // namespace
}  // namespace restenosis

#include <gtest/gtest.h>

#include <set>
#include <vector>

#include "tissue/agents/RandomStream.h"
#include "tissue/neighbours/PointGrid.h"

namespace restenosis {
namespace {

TEST(PointGrid, FindsWhatASearchOfAllPointsFinds) {
  RandomStream random(1, 0, 0, RandomPurpose::packing);
  const auto place = [&] { return Vec3(random.uniform(), random.uniform(), random.uniform()); };
  PointGrid grid({0.2, 0.2, 0.2}, {0.8, 0.8, 0.8}, 0.07);  // some points lie outside the box
  std::vector<Vec3> points;
  for (Index n = 0; n < 500; ++n) {
    points.push_back(place());
    grid.insert(n, points.back());
  }
  for (int query = 0; query < 100; ++query) {
    const Vec3 centre = place();
    std::set<Index> found, expected;
    grid.visit(centre, 0.15, [&](Index n, double squared) {
      EXPECT_DOUBLE_EQ(squared, (points[n] - centre).squaredNorm());
      EXPECT_TRUE(found.insert(n).second) << "visited twice";
      return true;
    });
    for (Index n = 0; n < points.size(); ++n) {
      if ((points[n] - centre).norm() < 0.15) expected.insert(n);
    }
    EXPECT_EQ(found, expected);
  }
}

TEST(PointGrid, BeginsInTheCellOfThePlace) {
  PointGrid grid({0, 0, 0}, {1, 1, 1}, 0.1);
  grid.insert(0, {0.44, 0.55, 0.55});
  grid.insert(1, {0.56, 0.55, 0.55});
  grid.insert(2, {0.56, 0.56, 0.55});
  grid.insert(3, {0.66, 0.55, 0.55});
  std::vector<Index> order;
  grid.visit({0.55, 0.55, 0.55}, 0.2, [&](Index n, double) {
    order.push_back(n);
    return true;
  });
  EXPECT_EQ(order, (std::vector<Index>{1, 2, 0, 3}));
  grid.fetch({5, -5, 0.5});  // a place beyond the box has a cell, too
}

TEST(PointGrid, StopsWhenTold) {
  PointGrid grid({0, 0, 0}, {1, 1, 1}, 0.5);
  for (Index n = 0; n < 10; ++n) grid.insert(n, {0.5, 0.5, 0.5});
  int visits = 0;
  EXPECT_FALSE(grid.visit({0.5, 0.5, 0.5}, 0.1, [&](Index, double) { return ++visits < 3; }));
  EXPECT_EQ(visits, 3);
}

}  // namespace
}  // namespace restenosis

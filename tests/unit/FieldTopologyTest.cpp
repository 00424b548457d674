#include <gtest/gtest.h>

#include <cmath>

#include "bridge/surface/FieldTopology.h"

namespace restenosis {
namespace {

struct Scenery {
  LumenGrid grid{20, 10, 1};
  GridField field{grid, -1}, strut{grid, 1};
  Scenery() {
    set([](const Vec3& p) { return std::hypot(p.x(), p.y()) < 5; }, 1);
  }
  template <class Inside>
  void set(Inside inside, float value) {
    for (int k = 0; k < grid.nz; ++k)
      for (int j = 0; j < grid.ny; ++j)
        for (int i = 0; i < grid.nx; ++i)
          if (inside(grid.node(i, j, k))) field.values[grid.index(i, j, k)] = value;
  }
  float at(int x, int y, int z) const {
    return field.values[grid.index(x + (grid.nx - 1) / 2, y + (grid.ny - 1) / 2, z)];
  }
};

TEST(FieldTopology, FillsCavitiesAndRemovesIslands) {
  Scenery s;
  s.set([](const Vec3& p) { return (p - Vec3(8, 0, 10)).norm() < 1.5; }, 1);
  s.set([](const Vec3& p) { return (p - Vec3(0, 1, 10)).norm() < 1.5; }, -1);
  const LumenTopology found = keepLumen(s.field, nullptr);
  EXPECT_TRUE(found.connected);
  EXPECT_EQ(found.cavities, 1U);
  EXPECT_EQ(found.islands, 1U);
  EXPECT_LT(s.at(8, 0, 10), 0);
  EXPECT_GT(s.at(0, 1, 10), 0);
}

TEST(FieldTopology, KeepsFloatingStruts) {
  Scenery s;
  s.set([](const Vec3& p) { return (p - Vec3(0, 1, 10)).norm() < 1.5; }, -1);
  s.strut.values[s.grid.index((s.grid.nx - 1) / 2, (s.grid.ny - 1) / 2 + 1, 10)] = -1;
  const BandField strut(s.strut);
  const LumenTopology found = keepLumen(s.field, &strut);
  EXPECT_EQ(found.floatingStruts, 1U);
  EXPECT_EQ(found.islands, 0U);
  EXPECT_LT(s.at(0, 1, 10), 0);
}

TEST(FieldTopology, SaysWhenNothingJoinsTheEnds) {
  Scenery s;
  s.set([](const Vec3& p) { return p.z() == 7; }, -1);
  const auto before = s.field.values;
  EXPECT_FALSE(keepLumen(s.field, nullptr).connected);
  EXPECT_EQ(before, s.field.values);
}

TEST(FieldTopology, ALumenThatLeavesTheAxisIsStillOne) {
  Scenery s;
  s.set([](const Vec3& p) { return std::hypot(p.x(), p.y()) < 2 && p.z() > 5 && p.z() < 15; }, -1);
  const LumenTopology found = keepLumen(s.field, nullptr);
  EXPECT_TRUE(found.connected);
  EXPECT_EQ(found.islands, 1U);
}

}  // namespace
}  // namespace restenosis

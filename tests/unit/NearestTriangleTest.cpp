#include <gtest/gtest.h>

#include <random>
#include <stdexcept>

#include "bridge/surface/NearestTriangle.h"

namespace restenosis {
namespace {

TEST(NearestTriangle, facesEdgesAndCorners) {
  const NearestTriangle one({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  EXPECT_TRUE(one.at({0.2, 0.3, 0.7}).point.isApprox(Vec3(0.2, 0.3, 0)));
  EXPECT_NEAR(one.at({0.2, 0.3, 0.7}).distance, 0.7, 1e-15);
  EXPECT_TRUE(one.at({0.4, -2, 1}).point.isApprox(Vec3(0.4, 0, 0)));
  EXPECT_TRUE(one.at({1, 1, 0}).point.isApprox(Vec3(0.5, 0.5, 0)));
  EXPECT_TRUE(one.at({3, -1, 2}).point.isApprox(Vec3(1, 0, 0)));
}

TEST(NearestTriangle, aTriangleWithoutWidthIsAnEdge) {
  const NearestTriangle edge({{0, 0, 0}, {2, 0, 0}}, {{0, 1, 1}});
  EXPECT_TRUE(edge.at({0.5, 1, 1}).point.isApprox(Vec3(0.5, 0, 0)));
  EXPECT_TRUE(edge.at({9, 1, 1}).point.isApprox(Vec3(2, 0, 0)));
}

/// A long triangle whose centre is far away may come nearer than one whose centre is near.
TEST(NearestTriangle, theNearestOfManyIsFound) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> in(-1, 1);
  std::vector<Vec3> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (std::uint32_t t = 0; t < 60; ++t) {
    const double size = t % 10 == 0 ? 2.0 : 0.1;
    const Vec3 corner(in(random), in(random), in(random));
    vertices.push_back(corner);
    for (int k = 0; k < 2; ++k)
      vertices.emplace_back(corner + size * Vec3(in(random), in(random), in(random)));
    triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  const NearestTriangle all(vertices, triangles);
  for (int n = 0; n < 200; ++n) {
    const Vec3 place(in(random), in(random), in(random));
    double least = 1e9;
    std::size_t nearest = 0;
    for (std::size_t t = 0; t < triangles.size(); ++t)
      if (const double d = NearestTriangle(vertices, {triangles[t]}).at(place).distance; d < least)
        least = d, nearest = t;
    EXPECT_EQ(all.at(place).triangle, nearest);
    EXPECT_EQ(all.at(place).distance, least);
  }
}

TEST(NearestTriangle, nothingToBeNearTo) {
  EXPECT_THROW(NearestTriangle({{0, 0, 0}}, {}), std::invalid_argument);
}

}  // namespace
}  // namespace restenosis

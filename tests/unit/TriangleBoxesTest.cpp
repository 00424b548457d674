#include <gtest/gtest.h>

#include <algorithm>

#include "bridge/surface/TriangleBoxes.h"
#include "tests/support/StrutSolids.h"

namespace restenosis {
namespace {

using namespace support;

std::vector<std::uint32_t> foundAlong(const TriangleBoxes& boxes, const Vec3& a, const Vec3& b) {
  std::vector<std::uint32_t> found;
  boxes.along(a, b, [&](std::uint32_t t) { found.push_back(t); });
  return found;
}

TEST(TriangleBoxes, EveryTriangleThatASegmentMeetsIsFoundAndFewOthers) {
  const TriSurface s = torus(3, 1, 0, 60);
  const TriangleBoxes boxes(s, 1e-9);
  for (std::uint32_t t = 0; t < s.triangles.size(); ++t) {
    const Vec3 normal = s.areaVector(t).normalized(), centre = s.centre(t);
    for (const auto& [a, b] : {std::pair(Vec3(centre - 0.3 * normal), Vec3(centre + 0.2 * normal)),
                               {s.vertices[s.triangles[t][0]], s.vertices[s.triangles[t][1]]},
                               {centre, centre}}) {
      const auto found = foundAlong(boxes, a, b);
      EXPECT_EQ(std::ranges::count(found, t), 1) << t;
      EXPECT_LT(found.size(), 100u);
    }
  }
}

TEST(TriangleBoxes, WhatIsOutOfReachIsNotFound) {
  const TriSurface s = box(Vec3::Zero(), {1, 1, 1});
  EXPECT_TRUE(foundAlong(TriangleBoxes(s, 0.1), {1.2, 0, 0}, {1.2, 1, 1}).empty());
  EXPECT_FALSE(foundAlong(TriangleBoxes(s, 0.3), {1.2, 0, 0}, {1.2, 1, 1}).empty());
  // Beside a corner of the box, whose own box its ends' box overlaps
  EXPECT_TRUE(foundAlong(TriangleBoxes(s, 0), {0.5, -0.6, 0.5}, {1.6, 0.5, 0.5}).empty());
  EXPECT_TRUE(foundAlong(TriangleBoxes(TriSurface(), 0), {0, 0, 0}, {1, 0, 0}).empty());
}

}  // namespace
}  // namespace restenosis

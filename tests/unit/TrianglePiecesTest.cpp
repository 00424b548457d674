#include <gtest/gtest.h>

#include "bridge/flow/TrianglePieces.h"

namespace restenosis {
namespace {

struct Total {
  int pieces = 0;
  double area = 0;
  Vec3 moment = Vec3::Zero();
};

Total totalOf(const Triangle& corners, double longest) {
  Total total;
  forEachPieceOf(corners, longest, [&](const Vec3& centre, double area) {
    ++total.pieces;
    total.area += area;
    total.moment += area * centre;
  });
  return total;
}

TEST(TrianglePieces, AreAllOfTheTriangle) {
  const std::array<Triangle, 5> triangles{Triangle{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)},
                                          {Vec3(1, 2, 3), Vec3(1.05, 2, 3), Vec3(1, 2.02, 8)},
                                          {Vec3(0, 0, 0), Vec3(6, 0, 0), Vec3(2.5, 0.1, 0.1)},
                                          {Vec3(0, 0, 0), Vec3(6, 0, 0), Vec3(-1, 0.1, 0.1)},
                                          {Vec3(-3, 1, 0), Vec3(4, 4, 1), Vec3(0, -5, 2)}};
  for (const Triangle& corners : triangles) {
    const double area = 0.5 * (corners[1] - corners[0]).cross(corners[2] - corners[0]).norm();
    const Vec3 centre = (corners[0] + corners[1] + corners[2]) / 3;
    for (const double longest : {100.0, 0.9, 0.3, 0.11}) {
      const Total total = totalOf(corners, longest);
      EXPECT_NEAR(total.area / area, 1, 1e-12);
      EXPECT_LT((total.moment / total.area - centre).norm(), 1e-12);
      if (longest == 100) {
        EXPECT_EQ(total.pieces, 1);
      }
    }
  }
}

TEST(TrianglePieces, OfAThinTriangleAreAsManyAsItIsLong) {
  const Triangle thin{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 0, 60)};
  EXPECT_NEAR(totalOf(thin, 1.5).pieces, 40, 1);
}

TEST(TrianglePieces, OfATriangleWithoutAreaHaveNone) {
  const Triangle line{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0.5, 0, 0)};
  EXPECT_EQ(totalOf(line, 0.1).area, 0);
}

}  // namespace
}  // namespace restenosis

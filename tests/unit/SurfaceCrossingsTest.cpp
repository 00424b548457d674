#include <gtest/gtest.h>

#include "bridge/surface/SurfaceCrossings.h"
#include "tests/support/StrutSolids.h"
#include "tests/support/SweptTube.h"
#include "tests/support/TubeSurface.h"

namespace restenosis {
namespace {

using namespace support;

SurfaceCrossings crossingsAsOnePiece(const TriSurface& s) {
  return surfaceCrossings(s, std::vector<std::uint32_t>(s.triangles.size(), 0));
}

TEST(SurfaceCrossings, SoundSurfacesHaveNone) {
  const TriSurface surfaces[] = {tube(0.9e-3, 10e-3),
                                 tube(0.9e-3, 10e-3, 1),
                                 stentedTube(0.9e-3, 3e-3, 90e-6),
                                 bentTube(0.5e-3, 0.6e-3, 1e-3, 0.4e-3),
                                 box(Vec3::Zero(), {1, 1, 1e-3}),
                                 torus(3, 1, 0, 12)};
  for (const TriSurface& s : surfaces) EXPECT_EQ(crossingsAsOnePiece(s).edges, 0u);
  EXPECT_EQ(crossingsAsOnePiece({}).edges, 0u);
}

TEST(SurfaceCrossings, EdgesThatGoThroughFacesAreFoundWithTheirPlace) {
  // One box's upper end stands in the other's middle, with its four upright edges and two diagonals
  const TriSurface s = together(box({-1, -1, 0}, {1, 1, 2}), box({-0.5, -0.4, -1}, {0.5, 0.4, 1}));
  const SurfaceCrossings found = crossingsAsOnePiece(s);
  EXPECT_GE(found.edges, 4u);
  EXPECT_NEAR(found.place.z(), 0, 1e-12);
  EXPECT_NEAR(std::abs(found.place.y()), 0.4, 1e-12);
}

TEST(SurfaceCrossings, DifferentPiecesMayCross) {
  const TriSurface s = together(box({-1, -1, 0}, {1, 1, 2}), box({-0.5, -0.4, -1}, {0.5, 0.4, 1}));
  std::vector<std::uint32_t> pieceOf(24, 0);
  std::fill(pieceOf.begin() + 12, pieceOf.end(), 1);
  EXPECT_EQ(surfaceCrossings(s, pieceOf).edges, 0u);
}

TEST(SurfaceCrossings, EdgesThatCrossInOnePointAreFound) {
  // All generatrices of this tube go through the same place of its axis
  TriSurface s = tube(1, 3, 3);
  for (Vec3& v : s.vertices)
    if (v.z() > 1.5 && v.z() < 2.5) v.head<2>() *= -0.3;
  EXPECT_GT(crossingsAsOnePiece(s).edges, 0u);
}

TEST(SurfaceCrossings, ATouchByRoundingIsNone) {
  const auto dent = [](double depth) {
    TriSurface s = tube(1, 3, 3);
    const std::uint32_t sides = 128, across = sides + sides / 2;
    s.vertices[sides] = s.vertices[across] + Vec3(-depth, 0, 0.5);
    return s;
  };
  // The dent's tip beside the middle of the wall over there
  EXPECT_EQ(crossingsAsOnePiece(dent(-1e-2)).edges, 0u);
  EXPECT_EQ(crossingsAsOnePiece(dent(1e-7)).edges, 0u);
  EXPECT_GT(crossingsAsOnePiece(dent(1e-2)).edges, 0u);
}

}  // namespace
}  // namespace restenosis

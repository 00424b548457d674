#include <gtest/gtest.h>

#include "bridge/surface/SurfaceEnds.h"
#include "bridge/surface/SurfacePieces.h"
#include "tests/support/StrutSolids.h"

namespace restenosis {
namespace {

using namespace support;

TEST(SurfacePieces, AreCountedAndOriented) {
  TriSurface s = together(box(Vec3::Zero(), {1, 1, 1}), box({2, 0, 0}, {3, 1, 1}));
  std::swap(s.triangles[5][0], s.triangles[5][1]);
  EXPECT_GT(surfaceEdges(s).opposed, 0u);
  const auto piece = orientPieces(s);
  EXPECT_EQ(surfaceEdges(s).opposed, 0u);
  for (std::size_t t = 0; t < piece.size(); ++t) EXPECT_EQ(piece[t], t < 12 ? 0u : 1u);
}

}  // namespace
}  // namespace restenosis

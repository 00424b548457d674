#include "bridge/surface/SurfacePieces.h"

#include <utility>

#include "bridge/surface/SurfaceEnds.h"

namespace restenosis {

std::vector<std::uint32_t> orientPieces(TriSurface& s) {
  const SurfaceEdges edges = surfaceEdges(s);
  std::vector<std::uint32_t> piece(s.triangles.size(), SurfaceEdges::none);
  std::uint32_t pieces = 0;
  const auto runsAlong = [&](std::uint32_t t, std::uint32_t from, std::uint32_t to) {
    for (int k = 0; k < 3; ++k)
      if (s.triangles[t][k] == from && s.triangles[t][(k + 1) % 3] == to) return true;
    return false;
  };
  for (std::uint32_t seed = 0; seed < s.triangles.size(); ++seed) {
    if (piece[seed] != SurfaceEdges::none) continue;
    std::vector<std::uint32_t> front{seed};
    piece[seed] = pieces;
    while (!front.empty()) {
      const std::uint32_t t = front.back();
      front.pop_back();
      const auto corners = s.triangles[t];
      for (const std::uint32_t other : edges.beyond[t]) {
        if (other == SurfaceEdges::none || piece[other] != SurfaceEdges::none) continue;
        for (int k = 0; k < 3; ++k)
          if (runsAlong(other, corners[k], corners[(k + 1) % 3])) {
            std::swap(s.triangles[other][1], s.triangles[other][2]);
            break;
          }
        piece[other] = pieces;
        front.push_back(other);
      }
    }
    ++pieces;
  }
  return piece;
}

}  // namespace restenosis

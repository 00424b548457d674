#pragma once

#include "tests/support/TubeSurface.h"

namespace restenosis::support {

/// The closed space between two tubes along z, the inner one `aside` from the outer one's axis along x [m].
/// Cross-sections are polygons of the circles' areas.
inline TriSurface annularTube(double outer, double inner, double length, double aside = 0.0, int pieces = 12,
                              std::uint32_t sides = 96) {
  TriSurface s;
  const double step = 2.0 * std::numbers::pi / sides, equalArea = std::sqrt(step / std::sin(step));
  const auto layers = static_cast<std::uint32_t>(pieces) + 1, all = layers * sides;
  for (const double radius : {outer, inner})
    for (std::uint32_t k = 0; k < layers; ++k)
      for (std::uint32_t i = 0; i < sides; ++i)
        s.vertices.push_back({(radius == inner ? aside : 0.0) + equalArea * radius * std::cos(i * step),
                              equalArea * radius * std::sin(i * step), length * k / pieces});
  const auto add = [&s](std::uint32_t a, std::uint32_t b, std::uint32_t c, SurfaceRegion region) {
    s.triangles.push_back({a, b, c});
    s.region.push_back(region);
  };
  const auto vertex = [&](bool isInner, std::uint32_t k, std::uint32_t i) {
    return (isInner ? all : 0) + k * sides + i % sides;
  };
  for (std::uint32_t i = 0; i < sides; ++i) {
    for (std::uint32_t k = 0; k + 1 < layers; ++k)
      for (const bool isInner : {false, true}) {  // the inner tube's outside is the lumen
        const std::uint32_t a = vertex(isInner, k, isInner ? i + 1 : i),
                            b = vertex(isInner, k, isInner ? i : i + 1);
        add(a, b, b + sides, SurfaceRegion::wall);
        add(a, b + sides, a + sides, SurfaceRegion::wall);
      }
    const auto ring = [&](std::uint32_t k, std::uint32_t i0, std::uint32_t i1, SurfaceRegion end) {
      add(vertex(false, k, i0), vertex(false, k, i1), vertex(true, k, i1), end);
      add(vertex(false, k, i0), vertex(true, k, i1), vertex(true, k, i0), end);
    };
    ring(0, i + 1, i, SurfaceRegion::inlet);
    ring(layers - 1, i, i + 1, SurfaceRegion::outlet);
  }
  return s;
}

}  // namespace restenosis::support

#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "bridge/flow/lbm/D3Q19.h"
#include "bridge/flow/lbm/LineCrossings.h"
#include "bridge/surface/TriSurface.h"

namespace restenosis {

/// Which nodes of a box of lattice nodes lie inside a closed surface, and which links the surface cuts.
class LatticeInterior {
 public:
  /// A link that the surface cuts, from node `lower` along `direction` (the first of its pair) to `upper`.
  struct Cut {
    d3q19::Step lower, upper;
    int direction;
    double first, last;  ///< distance of the first and last crossing from `lower` over the link's length
    std::uint32_t firstTriangle, lastTriangle;
  };

  /// @param vertices in lattice units  @param size nodes along x, y, z
  LatticeInterior(std::span<const Vec3> vertices, std::span<const std::array<std::uint32_t, 3>> triangles,
                  const d3q19::Step& size);

  /// Whether crossings and inside agree: a link between an inner and an outer node is cut an odd number of
  /// times, any other an even number. They do not where the surface passes through a node to within rounding.
  bool consistent() const;
  /// Keeps the inner nodes that are connected, along links that are not cut, with the inlet; false where the
  /// outlet is not among what they touch.
  bool keepConnected(std::span<const SurfaceRegion> regions);

  /// False outside the box.
  bool fluid(const d3q19::Step& n) const { return flags_[at(n)] & inside; }
  /// Whether the link of a node of the box in this direction is cut.
  bool cut(const d3q19::Step& n, int direction) const;
  /// Calls f(Cut) for every cut link, in a fixed order.
  template <class F>
  void forEachCut(F&& f) const;

 private:
  static constexpr std::uint16_t inside = 1;  // bits 1 to 9: link along the first of pair 0 to 8 is cut

  std::size_t at(const d3q19::Step& n) const {
    return (static_cast<std::size_t>(n[0] + 1) * static_cast<std::size_t>(size_[1] + 2) +
            static_cast<std::size_t>(n[1] + 1)) *
               static_cast<std::size_t>(size_[2] + 2) +
           static_cast<std::size_t>(n[2] + 1);
  }
  bool inBox(const d3q19::Step& n) const;
  bool inHalo(const d3q19::Step& n) const;
  void fillInside();
  void markCuts();

  d3q19::Step size_;
  std::vector<std::uint16_t> flags_;
  std::array<std::vector<SurfaceCrossing>, d3q19::pairs> crossings_;
};

template <class F>
void LatticeInterior::forEachCut(F&& f) const {
  for (int pair = 0; pair < d3q19::pairs; ++pair) {
    const int direction = 2 * pair + 1;
    const LinesAlong lines(d3q19::c[static_cast<std::size_t>(direction)]);
    const auto& list = crossings_[static_cast<std::size_t>(pair)];
    for (std::size_t i = 0, next = 0; i < list.size(); i = next) {
      const double start = std::floor(list[i].t);
      for (next = i + 1; next < list.size() && list[next].p == list[i].p && list[next].q == list[i].q &&
                         std::floor(list[next].t) == start;)
        ++next;
      const auto t = static_cast<std::int32_t>(start);
      const Cut cut{lines.node(list[i].p, list[i].q, t),
                    lines.node(list[i].p, list[i].q, t + 1),
                    direction,
                    list[i].t - start,
                    list[next - 1].t - start,
                    list[i].triangle,
                    list[next - 1].triangle};
      if (inHalo(cut.lower) && inHalo(cut.upper)) f(cut);
    }
  }
}

}  // namespace restenosis

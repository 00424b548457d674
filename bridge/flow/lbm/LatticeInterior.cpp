#include "bridge/flow/lbm/LatticeInterior.h"

#include <algorithm>
#include <cmath>

namespace restenosis {

LatticeInterior::LatticeInterior(std::span<const Vec3> vertices,
                                 std::span<const std::array<std::uint32_t, 3>> triangles,
                                 const d3q19::Step& size)
    : size_(size),
      flags_(static_cast<std::size_t>(size[0] + 2) * static_cast<std::size_t>(size[1] + 2) *
             static_cast<std::size_t>(size[2] + 2)) {
#pragma omp parallel for schedule(dynamic, 1)
  for (std::size_t pair = 0; pair < d3q19::pairs; ++pair)
    crossings_[pair] = crossings(vertices, triangles, d3q19::c[2 * pair + 1]);
  fillInside();
  markCuts();
}

bool LatticeInterior::inBox(const d3q19::Step& n) const {
  return n[0] >= 0 && n[1] >= 0 && n[2] >= 0 && n[0] < size_[0] && n[1] < size_[1] && n[2] < size_[2];
}

bool LatticeInterior::inHalo(const d3q19::Step& n) const {
  return n[0] >= -1 && n[1] >= -1 && n[2] >= -1 && n[0] <= size_[0] && n[1] <= size_[1] && n[2] <= size_[2];
}

bool LatticeInterior::cut(const d3q19::Step& n, int direction) const {
  const bool first = direction % 2 == 1;
  const int pair = (direction - 1) / 2;
  return flags_[at(first ? n : d3q19::moved(n, direction))] & (2u << pair);
}

void LatticeInterior::fillInside() {
  const auto& list = crossings_[0];  // along x
  const LinesAlong lines(d3q19::c[1]);
  for (std::size_t i = 0; i + 1 < list.size(); i += 2) {
    const auto &in = list[i], &out = list[i + 1];
    if (in.p != out.p || in.q != out.q) continue;  // not closed: found by consistent()
    for (auto t = static_cast<std::int32_t>(std::ceil(in.t)); t <= out.t; ++t)
      if (const auto node = lines.node(in.p, in.q, t); inBox(node)) flags_[at(node)] |= inside;
  }
}

void LatticeInterior::markCuts() {
  forEachCut([this](const Cut& cut) {
    flags_[at(cut.lower)] |= static_cast<std::uint16_t>(2u << ((cut.direction - 1) / 2));
  });
}

bool LatticeInterior::consistent() const {
  // Parity of the crossings of every link, kept like the flags of cuts
  std::vector<std::uint16_t> odd(flags_.size());
  for (std::size_t pair = 0; pair < d3q19::pairs; ++pair) {
    const LinesAlong lines(d3q19::c[2 * pair + 1]);
    for (const auto& crossing : crossings_[pair]) {
      const auto node = lines.node(crossing.p, crossing.q, static_cast<std::int32_t>(std::floor(crossing.t)));
      if (inHalo(node)) odd[at(node)] ^= static_cast<std::uint16_t>(2u << pair);
    }
  }
  for (int x = 0; x < size_[0]; ++x)
    for (int y = 0; y < size_[1]; ++y)
      for (int z = 0; z < size_[2]; ++z) {
        const d3q19::Step node{x, y, z};
        for (int direction = 1; direction < d3q19::directions; ++direction) {
          const d3q19::Step other = d3q19::moved(node, direction);
          const std::size_t lower = at(direction % 2 == 1 ? node : other);
          const bool change = fluid(node) != fluid(other);
          if (change != ((odd[lower] & (2u << ((direction - 1) / 2))) != 0)) return false;
        }
      }
  return true;
}

bool LatticeInterior::keepConnected(std::span<const SurfaceRegion> regions) {
  std::vector<d3q19::Step> front;
  std::vector<bool> reached(flags_.size(), false);
  const auto reach = [&](const d3q19::Step& n) {
    if (!fluid(n) || reached[at(n)]) return;
    reached[at(n)] = true;
    front.push_back(n);
  };
  const auto forEachEndNode = [&](SurfaceRegion end, auto&& f) {
    forEachCut([&](const Cut& cut) {
      if (regions[cut.firstTriangle] == end) f(cut.lower);
      if (regions[cut.lastTriangle] == end) f(cut.upper);
    });
  };
  forEachEndNode(SurfaceRegion::inlet, reach);
  while (!front.empty()) {
    const d3q19::Step node = front.back();
    front.pop_back();
    for (int direction = 1; direction < d3q19::directions; ++direction)
      if (!cut(node, direction)) reach(d3q19::moved(node, direction));
  }
  bool joined = false;
  forEachEndNode(SurfaceRegion::outlet, [&](const d3q19::Step& n) { joined = joined || reached[at(n)]; });
  for (std::size_t i = 0; i < flags_.size(); ++i)
    if (!reached[i]) flags_[i] &= static_cast<std::uint16_t>(~inside);
  return joined;
}

}  // namespace restenosis

#include "bridge/surface/TriangleBoxes.h"

#include <numeric>

namespace restenosis {
namespace {

constexpr std::uint32_t leafSize = 4;  // speed only

}  // namespace

TriangleBoxes::TriangleBoxes(const TriSurface& s, double margin) : order_(s.triangles.size()) {
  if (order_.empty()) return;
  std::iota(order_.begin(), order_.end(), 0U);
  std::vector<Vec3> centres;
  centres.reserve(order_.size());
  for (std::size_t t = 0; t < order_.size(); ++t) centres.push_back(s.centre(t));

  struct Part {
    std::uint32_t node, first, last;  // a node to be made, and its triangles in order_
  };
  nodes_.emplace_back();
  std::vector<Part> parts{{0, 0, static_cast<std::uint32_t>(order_.size())}};
  while (!parts.empty()) {
    const auto [n, first, last] = parts.back();
    parts.pop_back();
    Eigen::AlignedBox3d box, boxOfCentres;
    for (std::uint32_t k = first; k < last; ++k) {
      for (const auto v : s.triangles[order_[k]]) box.extend(s.vertices[v]);
      boxOfCentres.extend(centres[order_[k]]);
    }
    Node& node = nodes_[n];
    node.centre = box.center();
    node.reach = 0.5 * box.sizes() + Vec3::Constant(margin);
    if (last - first <= leafSize) {
      node.first = first;
      node.count = last - first;
      continue;
    }
    Eigen::Index axis = 0;
    boxOfCentres.sizes().maxCoeff(&axis);
    const std::uint32_t middle = first + (last - first) / 2;
    std::nth_element(order_.begin() + first, order_.begin() + middle, order_.begin() + last,
                     [&](auto a, auto b) { return centres[a][axis] < centres[b][axis]; });
    const auto children = static_cast<std::uint32_t>(nodes_.size());
    node.first = children;
    node.second = children + 1;
    nodes_.resize(nodes_.size() + 2);
    parts.push_back({children + 1, middle, last});
    parts.push_back({children, first, middle});
  }
}

}  // namespace restenosis

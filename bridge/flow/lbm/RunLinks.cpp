#include "bridge/flow/lbm/RunLinks.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

namespace restenosis {
namespace {

/// Items in the order of the runs that they belong to, and of those of a run as they were; [r] of `first` is
/// where those of run r begin.
template <class Item>
std::vector<Item> byRun(const ColumnLayout& layout, const std::vector<Item>& items,
                        std::vector<std::uint32_t>& first) {
  const auto& runs = layout.runs();
  std::vector<std::uint32_t> run;
  run.reserve(items.size());
  for (const Item& item : items) {
    // Runs follow each other in the order of their places
    const auto after =
        std::upper_bound(runs.begin(), runs.end(), item.node,
                         [](std::uint32_t place, const NodeRun& r) { return place < r.first; });
    run.push_back(static_cast<std::uint32_t>(after - runs.begin()) - 1);
  }
  first.assign(runs.size() + 1, 0);
  for (const std::uint32_t r : run) ++first[r + 1];
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<Item> sorted(items.size());
  auto next = first;
  for (std::size_t i = 0; i < items.size(); ++i) sorted[next[run[i]]++] = items[i];
  return sorted;
}

}  // namespace

template <class Real>
RunLinks<Real>::RunLinks(const ColumnLayout& layout, const LatticeBoundary& boundary)
    : expectedOutflow_(boundary.expectedOutflow) {
  const auto& runs = layout.runs();
  const auto wall = byRun(layout, boundary.wall, firstWall_);
  const auto nodes = byRun(layout, boundary.pressureNodes, firstEnd_);
  walls_.reserve(wall.size());
  kept_.resize(wall.size());
  ends_.reserve(nodes.size());
  for (std::size_t r = 0; r < runs.size(); ++r) {
    firstSource_.push_back(static_cast<std::uint32_t>(sources_.size()));
    for (std::uint32_t i = firstWall_[r]; i < firstWall_[r + 1]; ++i) {
      const auto& l = wall[i];
      walls_.push_back({l.node - runs[r].first, l.direction, l.inward, static_cast<Real>(l.k)});
      if (l.source != 0.0) sources_.push_back({i, static_cast<Real>(l.source)});
    }
    for (std::uint32_t i = firstEnd_[r]; i < firstEnd_[r + 1]; ++i) {
      const auto& n = nodes[i];
      const auto offset = static_cast<std::int64_t>(n.node - runs[r].first);
      ends_.push_back(
          {static_cast<std::uint32_t>(offset + n.inward), n.inward, n.links, n.outlet, n.density, 0.0, 0.0});
      outletNodes_ += n.outlet ? 1 : 0;
    }
  }
  firstSource_.push_back(static_cast<std::uint32_t>(sources_.size()));
}

template <class Real>
void RunLinks<Real>::keep(std::size_t run, const Slots<Real>& left) {
  for (std::uint32_t i = firstWall_[run]; i < firstWall_[run + 1]; ++i) {
    const Wall& l = walls_[i];
    const std::size_t towards = l.direction, away = static_cast<std::size_t>(d3q19::opposite(l.direction));
    const std::ptrdiff_t at = l.offset;
    kept_[i] = left[away][at] - l.k * left[towards][at + l.inward];
  }
  for (std::uint32_t i = firstSource_[run]; i < firstSource_[run + 1]; ++i)
    kept_[sources_[i].wall] += sources_[i].value;
  for (std::uint32_t i = firstEnd_[run]; i < firstEnd_[run + 1]; ++i) {
    End& end = ends_[i];
    // Collisions keep the density; where a population arrived, its opposite leaves
    double density = 0.0, momentum = 0.0;
    for (std::size_t d = 0; d < d3q19::directions; ++d) {
      const auto f = static_cast<double>(left[d][end.inner]);
      density += f;
      momentum -= f * d3q19::c[d][2];
    }
    end.density = density;
    end.velocity = momentum;
  }
}

template <class Real>
void RunLinks<Real>::arrive(std::size_t run, const Slots<Real>& arriving) const {
  for (std::uint32_t i = firstWall_[run]; i < firstWall_[run + 1]; ++i) {
    const Wall& l = walls_[i];
    const std::size_t towards = l.direction, away = static_cast<std::size_t>(d3q19::opposite(l.direction));
    const std::ptrdiff_t at = l.offset;
    arriving[away][at] = kept_[i] + l.k * arriving[towards][at + l.inward];
  }
  for (std::uint32_t i = firstEnd_[run]; i < firstEnd_[run + 1]; ++i) {
    const End& end = ends_[i];
    const double onPlane = end.given + (end.outlet ? outletDensity_ : 0.0);
    const double change = 2.0 / 3.0 * (onPlane - end.density);
    const auto inner = static_cast<std::ptrdiff_t>(end.inner);
    for (std::uint32_t links = end.links; links != 0; links &= links - 1) {
      const int direction = std::countr_zero(links);
      Real* const incoming = arriving[static_cast<std::size_t>(d3q19::opposite(direction))];
      incoming[inner - end.inward] = incoming[inner] + static_cast<Real>(d3q19::weight(direction) * change);
    }
  }
}

template <class Real>
void RunLinks<Real>::releaseSound() {
  if (expectedOutflow_ < 0.0 || outletNodes_ == 0) return;
  double outflow = 0.0;
  for (const End& end : ends_)
    if (end.outlet) outflow += end.velocity;
  // A plane wave that leaves: p = u times the speed of sound 1 / sqrt(3), and 3 p is the density's departure
  outletDensity_ = std::sqrt(3.0) * (outflow - expectedOutflow_) / static_cast<double>(outletNodes_);
}

template class RunLinks<float>;
template class RunLinks<double>;

}  // namespace restenosis

#include "bridge/flow/lbm/OpenLinks.h"

#include <algorithm>
#include <cmath>

namespace restenosis {
namespace {

/// By how much of the way the outlet's density follows what has left. What comes back through these links
/// answers to it within a step, so that the full change would swing (assumed).
constexpr double follows = 0.1;

Vec3 vectorOf(int direction) {
  const auto& c = d3q19::c[static_cast<std::size_t>(direction)];
  return {static_cast<double>(c[0]), static_cast<double>(c[1]), static_cast<double>(c[2])};
}

}  // namespace

template <class Real>
OpenLinks<Real>::OpenLinks(const ColumnLayout& layout, const LatticeBoundary& boundary, double tau)
    : expectedOutflow_(boundary.expectedOutflow), area_(boundary.outletArea) {
  const auto slot = [&](const d3q19::Step& node, int direction) {
    return static_cast<Slot>(direction) * layout.places() + layout.place(node);
  };
  const auto nodeAt = [&](const d3q19::Step& at) {
    Node node{};
    for (int i = 0; i < d3q19::directions; ++i) {
      node.afterEven[static_cast<std::size_t>(i)] = slot(at, d3q19::opposite(i));
      node.afterOdd[static_cast<std::size_t>(i)] = slot(d3q19::moved(at, i), i);
    }
    return node;
  };
  for (const LatticeBoundary::OpenLink& open : boundary.open) {
    const int back = d3q19::opposite(open.direction);
    links_.push_back({.node = nodeAt(open.node),
                      .behind = open.wallBehind > 0.0 ? Node{} : nodeAt(d3q19::moved(open.node, back)),
                      .arrivesOdd = slot(d3q19::moved(open.node, open.direction), open.direction),
                      .arrivesEven = slot(open.node, back),
                      .direction = open.direction,
                      .alone = open.alone,
                      .wallBehind = open.wallBehind > 0.0 ? open.wallBehind : 0.0,
                      .density = open.density,
                      .outflow = 0.0,
                      .place = layout.place(open.node),
                      .shear = 3.0 * (2.0 * tau - 1.0)});
  }
}

template <class Real>
void OpenLinks<Real>::setViscosity(const std::function<double(std::uint32_t)>& viscosity) {
  for (Link& link : links_) link.shear = 18.0 * viscosity(link.place);
}

template <class Real>
Vec3 OpenLinks<Real>::Node::velocity(const Real* populations, bool even) const {
  Vec3 u = Vec3::Zero();
  for (int i = 1; i < d3q19::directions; ++i)
    u += static_cast<double>(populations[(even ? afterEven : afterOdd)[static_cast<std::size_t>(i)]]) *
         vectorOf(i);
  return u;
}

template <class Real>
void OpenLinks<Real>::serve(std::size_t n, bool afterEven, Real* populations) {
  Link& link = links_[n];
  const Vec3 c = vectorOf(link.direction), u = link.node.velocity(populations, afterEven);
  const double cu = c.dot(u), w = d3q19::weight(link.direction);
  const double even = link.density + density_ + 4.5 * cu * cu - 1.5 * u.squaredNorm();
  // Nearer walls would make the term of the shear so large that it swings
  const double gradient = link.wallBehind > 0.0 ? cu / std::max(link.wallBehind, link.shear / 3.0)
                                                : cu - c.dot(link.behind.velocity(populations, afterEven));
  const Node& node = link.node;
  const double left = populations[(afterEven ? node.afterEven : node.afterOdd)[link.direction]];
  const double back = link.alone ? w * (even - 3.0 * cu) : -left + w * (2.0 * even - link.shear * gradient);
  populations[afterEven ? link.arrivesOdd : link.arrivesEven] = static_cast<Real>(back);
  link.outflow = left - back;
}

template <class Real>
void OpenLinks<Real>::releaseSound() {
  if (expectedOutflow_ < 0.0 || links_.empty()) return;
  // A plane wave that leaves: p = u times the speed of sound 1 / sqrt(3), and 3 p is the density's departure
  density_ = std::lerp(density_, std::sqrt(3.0) * (outflow() - expectedOutflow_) / area_, follows);
}

template <class Real>
double OpenLinks<Real>::outflow() const {
  double sum = 0.0;
  for (const Link& link : links_) sum += link.outflow;
  return sum;
}

template class OpenLinks<float>;
template class OpenLinks<double>;

}  // namespace restenosis

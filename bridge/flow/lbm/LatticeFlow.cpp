#include "LatticeFlow.h"

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <new>
#include <utility>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace restenosis {
namespace {

constexpr std::size_t nodesPerShare = 8192;
constexpr std::size_t hugePage = std::size_t{1} << 21;

/// Runs in portions: indices of the first run of each, and the number of runs.
std::vector<std::size_t> portions(const std::vector<NodeRun>& runs) {
  std::vector<std::size_t> first{0};
  std::size_t nodes = 0;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (nodes >= nodesPerShare) {
      first.push_back(i);
      nodes = 0;
    }
    nodes += runs[i].count;
  }
  first.push_back(runs.size());
  return first;
}

/// Symmetric and antisymmetric parts of the equilibrium of a direction.
struct Equilibrium {
  double even, odd;
};
Equilibrium equilibrium(int i, double density, const Vec3& u) {
  const auto& c = d3q19::c[static_cast<std::size_t>(i)];
  const double cu = c[0] * u.x() + c[1] * u.y() + c[2] * u.z();
  const double w = d3q19::weight(i);
  return {w * (density + 4.5 * cu * cu - 1.5 * u.squaredNorm()), 3.0 * w * cu};
}

/// The components of a symmetric tensor in the order of NodeState::stress.
constexpr std::array<std::array<std::size_t, 2>, 6> components = {
    {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}}};

}  // namespace

template <class Real>
void LatticeFlow<Real>::Free::operator()(Real* p) const {
  std::free(p);
}

template <class Real>
LatticeFlow<Real>::LatticeFlow(const ColumnLayout& layout, LatticeBoundary boundary,
                               const LatticeRelaxation& relaxation)
    : layout_(layout),
      relaxation_(relaxation),
      boundary_(std::move(boundary)),
      shares_(portions(layout.runs())) {
  collision_.evenRate = static_cast<Real>(1.0 / relaxation.tau);
  collision_.oddRate = static_cast<Real>(1.0 / relaxation.oddTau());
  for (std::size_t d = 0; d < 3; ++d)
    collision_.force[d] = static_cast<Real>(relaxation.force[static_cast<int>(d)]);
  forced_ = !relaxation.force.isZero();
  wall_.reserve(boundary_.wall.size());
  for (const auto& l : boundary_.wall)
    wall_.push_back({l.near, l.far, l.behind, l.here, static_cast<Real>(l.k), static_cast<Real>(l.source)});
  boundary_.wall = {};
  ends_.resize(boundary_.pressureNodes.size());
  for (const auto& node : boundary_.pressureNodes) outletNodes_ += node.outlet ? 1 : 0;
  if (!ends_.empty()) findEndsOfRuns();
  allocate();
}

template <class Real>
void LatticeFlow<Real>::findEndsOfRuns() {
  const auto& runs = layout_.runs();
  std::vector<std::vector<EndOfRun>> of(runs.size());
  for (std::size_t n = 0; n < boundary_.pressureNodes.size(); ++n) {
    const std::uint32_t inner = boundary_.pressureNodes[n].inner;
    // Runs follow each other in the order of their places
    const auto after =
        std::upper_bound(runs.begin(), runs.end(), inner,
                         [](std::uint32_t place, const NodeRun& r) { return place < r.first; });
    const auto run = static_cast<std::size_t>(after - runs.begin()) - 1;
    of[run].push_back({inner - runs[run].first, static_cast<std::uint32_t>(n)});
  }
  for (const auto& ends : of) {
    firstEnd_.push_back(static_cast<std::uint32_t>(endsOfRuns_.size()));
    endsOfRuns_.insert(endsOfRuns_.end(), ends.begin(), ends.end());
  }
  firstEnd_.push_back(static_cast<std::uint32_t>(endsOfRuns_.size()));
}

template <class Real>
void LatticeFlow<Real>::allocate() {
  const std::size_t count = static_cast<std::size_t>(d3q19::directions) * layout_.places();
  const std::size_t bytes = (count * sizeof(Real) + hugePage - 1) / hugePage * hugePage;
  populations_.reset(static_cast<Real*>(std::aligned_alloc(hugePage, bytes)));
  if (!populations_) throw std::bad_alloc();
#if defined(__linux__)
  madvise(populations_.get(), bytes, MADV_HUGEPAGE);  // fewer page walks; without it all works the same
#endif
  Real* const all = populations_.get();
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < count; ++i) all[i] = 0;
}

template <class Real>
void LatticeFlow<Real>::initialise(const std::function<NodeState(std::uint32_t)>& state) {
  const double factor = -1.0 / (1.0 - 0.5 / relaxation_.tau);  // from stress to departure from equilibrium
  const auto& runs = layout_.runs();
#pragma omp parallel for schedule(dynamic, 16)
  for (std::size_t r = 0; r < runs.size(); ++r)
    for (std::uint32_t n = 0; n < runs[r].count; ++n) {
      const std::uint32_t place = runs[r].first + n;
      const NodeState s = state(place);
      const Vec3 u = s.velocity - 0.5 * relaxation_.force;
      const double trace = (s.stress[0] + s.stress[1] + s.stress[2]) / 3.0;
      for (int i = 0; i < d3q19::directions; ++i) {
        const auto& c = d3q19::c[static_cast<std::size_t>(i)];
        double departure = 0.0;
        for (std::size_t k = 0; k < 6; ++k)
          departure += (k < 3 ? 1.0 : 2.0) * s.stress[k] * c[components[k][0]] * c[components[k][1]];
        departure = 4.5 * d3q19::weight(i) * factor * (departure - trace);
        const Equilibrium e = equilibrium(i, s.density, u);
        populations_[slot(place, i)] = static_cast<Real>(e.even + e.odd + departure);
      }
    }
}

template <class Real>
void LatticeFlow<Real>::collide(std::size_t index, Parity parity) {
  const NodeRun& run = layout_.runs()[index];
  Real* slots[d3q19::directions];
  for (int i = 0; i < d3q19::directions; ++i) {
    const auto& c = d3q19::c[static_cast<std::size_t>(i)];
    slots[i] = parity == Parity::even
                   ? populations_.get() + slot(run.first, i)
                   : populations_.get() +
                         slot(layout_.place(run.x - c[0], run.y - c[1], run.z - c[2]), d3q19::opposite(i));
  }
  if (forced_)
    collideRun<Real, true>(slots, run.count, collision_);
  else
    collideRun<Real, false>(slots, run.count, collision_);
  if (!firstEnd_.empty()) takeEnds(index, slots);
}

template <class Real>
void LatticeFlow<Real>::takeEnds(std::size_t run, Real* const* slots) {
  for (std::uint32_t e = firstEnd_[run]; e < firstEnd_[run + 1]; ++e) {
    // Collisions keep the density and add the force; where a population arrived, its opposite leaves.
    double density = 0.0, momentum = 0.0;
    for (int i = 0; i < d3q19::directions; ++i) {
      const auto f = static_cast<double>(slots[i][endsOfRuns_[e].offset]);
      density += f;
      momentum -= f * d3q19::c[static_cast<std::size_t>(i)][2];
    }
    ends_[endsOfRuns_[e].node] = {density, momentum - 0.5 * relaxation_.force.z()};
  }
}

template <class Real>
template <typename LatticeFlow<Real>::Parity parity>
Real LatticeFlow<Real>::arriving(const LatticeBoundary::PressureNode& node, int direction) const {
  const int opposite = d3q19::opposite(direction);
  return populations_[parity == Parity::even
                          ? slot(node.neighbour[static_cast<std::size_t>(opposite)], opposite)
                          : slot(node.inner, direction)];
}

template <class Real>
template <typename LatticeFlow<Real>::Parity parity>
void LatticeFlow<Real>::applyPressure() {
  if (boundary_.expectedOutflow >= 0.0) {
#pragma omp single
    {
      double outflow = 0.0;  // one after the other, so that the sum does not depend on the threads
      for (std::size_t n = 0; n < ends_.size(); ++n)
        if (boundary_.pressureNodes[n].outlet) outflow += ends_[n].velocity;
      // A plane wave that leaves: p = u times the speed of sound 1 / sqrt(3), and 3 p is the density's
      // departure
      outletDensity_ =
          std::sqrt(3.0) * (outflow - boundary_.expectedOutflow) / static_cast<double>(outletNodes_);
    }
  }
#pragma omp for schedule(static)
  for (std::size_t n = 0; n < boundary_.pressure.size(); ++n) {
    const auto& link = boundary_.pressure[n];
    const auto& node = boundary_.pressureNodes[link.node];
    const int incoming = d3q19::opposite(link.direction);
    const double onPlane = link.density + (node.outlet ? outletDensity_ : 0.0);
    const double change = 2.0 / 3.0 * (onPlane - ends_[link.node].density);
    populations_[parity == Parity::even ? link.far : link.near] =
        arriving<parity>(node, incoming) + static_cast<Real>(d3q19::weight(link.direction) * change);
  }
}

template <class Real>
template <typename LatticeFlow<Real>::Parity parity>
void LatticeFlow<Real>::applyBoundary() {
  Real* const f = populations_.get();
  if (!boundary_.passages.empty()) {
#pragma omp for schedule(static)
    for (std::size_t n = 0; n < boundary_.passages.size(); ++n) {
      const auto& p = boundary_.passages[n];
      if constexpr (parity == Parity::even)
        f[p.evenTo] = f[p.evenFrom];
      else
        f[p.oddTo] = f[p.oddFrom];
    }
  }
#pragma omp for schedule(static)
  for (std::size_t n = 0; n < wall_.size(); ++n) {
    const WallLink& l = wall_[n];
    const Real correction = l.k * (f[l.behind] - f[l.here]);
    if constexpr (parity == Parity::even)
      f[l.far] = f[l.near] + correction + l.source;
    else
      f[l.near] = f[l.far] - correction + l.source;
  }
  if (!boundary_.thin.empty()) {
#pragma omp for schedule(static)
    for (std::size_t n = 0; n < boundary_.thin.size(); ++n)
      std::swap(f[boundary_.thin[n].a], f[boundary_.thin[n].b]);
  }
  if (!boundary_.pressure.empty()) applyPressure<parity>();
}

template <class Real>
void LatticeFlow<Real>::advance(int pairs) {
  const std::size_t portionCount = shares_.size() - 1;
#pragma omp parallel
  for (int pair = 0; pair < pairs; ++pair) {
    const auto sweep = [&](Parity parity) {
#pragma omp for schedule(dynamic, 1)
      for (std::size_t portion = 0; portion < portionCount; ++portion)
        for (std::size_t r = shares_[portion]; r < shares_[portion + 1]; ++r) collide(r, parity);
    };
    sweep(Parity::even);
    applyBoundary<Parity::even>();
    sweep(Parity::odd);
    applyBoundary<Parity::odd>();
  }
}

template <class Real>
NodeState LatticeFlow<Real>::state(std::uint32_t place) const {
  NodeState s;
  std::array<double, d3q19::directions> f{};
  for (int i = 0; i < d3q19::directions; ++i) {
    const auto at = static_cast<std::size_t>(i);
    f[at] = populations_[slot(place, i)];
    s.density += f[at];
    s.velocity += f[at] * Vec3(d3q19::c[at][0], d3q19::c[at][1], d3q19::c[at][2]);
  }
  s.velocity += 0.5 * relaxation_.force;
  std::array<double, 6> departure{};
  for (int i = 1; i < d3q19::directions; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const Equilibrium e = equilibrium(i, s.density, s.velocity);
    for (std::size_t k = 0; k < 6; ++k)
      departure[k] +=
          (f[at] - e.even - e.odd) * d3q19::c[at][components[k][0]] * d3q19::c[at][components[k][1]];
  }
  for (std::size_t k = 0; k < 6; ++k) {
    const auto a = static_cast<int>(components[k][0]), b = static_cast<int>(components[k][1]);
    const double uForce = s.velocity[a] * relaxation_.force[b] + s.velocity[b] * relaxation_.force[a];
    s.stress[k] = -(1.0 - 0.5 / relaxation_.tau) * (departure[k] + 0.5 * uForce);
  }
  return s;
}

template class LatticeFlow<float>;
template class LatticeFlow<double>;

}  // namespace restenosis

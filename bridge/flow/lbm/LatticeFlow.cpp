#include "bridge/flow/lbm/LatticeFlow.h"

#include <omp.h>

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
      links_(layout, boundary),
      open_(layout, boundary, relaxation.tau),
      thin_(std::move(boundary.thin)),
      passages_(std::move(boundary.passages)),
      shares_(portions(layout.runs())) {
  collision_.evenRate = static_cast<Real>(1.0 / relaxation.tau);
  collision_.oddRate = static_cast<Real>(1.0 / relaxation.oddTau());
  for (std::size_t d = 0; d < 3; ++d)
    collision_.force[d] = static_cast<Real>(relaxation.force[static_cast<int>(d)]);
  forced_ = !relaxation.force.isZero();
  allocate();
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
  const auto& runs = layout_.runs();
#pragma omp parallel for schedule(dynamic, 16)
  for (std::size_t r = 0; r < runs.size(); ++r)
    for (std::uint32_t n = 0; n < runs[r].count; ++n) {
      const std::uint32_t place = runs[r].first + n;
      const NodeState s = state(place);
      const double factor =
          -1.0 / (1.0 - 0.5 * evenRate(place));  // from stress to departure from equilibrium
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
Slots<Real> LatticeFlow<Real>::slots(std::size_t index, Parity parity) const {
  const NodeRun& run = layout_.runs()[index];
  Slots<Real> result;
  for (int i = 0; i < d3q19::directions; ++i) {
    const auto& c = d3q19::c[static_cast<std::size_t>(i)];
    const std::uint32_t first =
        parity == Parity::even
            ? slot(run.first, i)
            : slot(layout_.place(run.x - c[0], run.y - c[1], run.z - c[2]), d3q19::opposite(i));
    result[static_cast<std::size_t>(i)] = populations_.get() + first;
  }
  return result;
}

template <class Real>
void LatticeFlow<Real>::step(std::size_t run, Parity parity, bool first) {
  const Slots<Real> at = slots(run, parity);
  if (!first) links_.arrive(run, at);
  if (evenRates_.empty())
    collide<false>(run, at);
  else
    collide<true>(run, at);
  links_.keep(run, at);
}

template <class Real>
template <bool varying>
void LatticeFlow<Real>::collide(std::size_t index, const Slots<Real>& at) {
  const NodeRun& run = layout_.runs()[index];
  NodeRates<Real> rates;
  if constexpr (varying) rates = {evenRates_.data() + run.first, oddRates_.data() + run.first};
  if (forced_)
    collideRun<Real, true, varying>(at.data(), run.count, collision_, rates);
  else
    collideRun<Real, false, varying>(at.data(), run.count, collision_, rates);
}

template <class Real>
void LatticeFlow<Real>::setViscosity(const std::function<double(std::uint32_t)>& viscosity) {
  if (evenRates_.empty()) {
    evenRates_.assign(layout_.places(), collision_.evenRate);
    oddRates_.assign(layout_.places(), collision_.oddRate);
  }
  const auto& runs = layout_.runs();
#pragma omp parallel for schedule(dynamic, 16)
  for (std::size_t r = 0; r < runs.size(); ++r)
    for (std::uint32_t place = runs[r].first; place < runs[r].first + runs[r].count; ++place) {
      const double tau = 0.5 + 3.0 * viscosity(place);
      evenRates_[place] = static_cast<Real>(1.0 / tau);
      oddRates_[place] = static_cast<Real>(1.0 / relaxation_.oddTauOf(tau));
    }
  open_.setViscosity([this](std::uint32_t place) { return this->viscosity(place); });
}

template <class Real>
template <typename LatticeFlow<Real>::Parity parity>
void LatticeFlow<Real>::joinEnds() {
  Real* const f = populations_.get();
  if (!passages_.empty()) {
#pragma omp for schedule(static)
    for (std::size_t n = 0; n < passages_.size(); ++n) {
      const auto& p = passages_[n];
      if constexpr (parity == Parity::even)
        f[p.evenTo] = f[p.evenFrom];
      else
        f[p.oddTo] = f[p.oddFrom];
    }
  }
  if (!thin_.empty()) {
#pragma omp for schedule(static)
    for (std::size_t n = 0; n < thin_.size(); ++n) std::swap(f[thin_[n].a], f[thin_[n].b]);
  }
  if (open_.size() > 0) {
#pragma omp for schedule(static)
    for (std::size_t n = 0; n < open_.size(); ++n) open_.serve(n, parity == Parity::even, f);
  }
#pragma omp single
  {
    links_.releaseSound();
    open_.releaseSound();
  }
}

template <class Real>
void LatticeFlow<Real>::advance(int pairs) {
  if (pairs == 0) return;
  const std::size_t portionCount = shares_.size() - 1;
#pragma omp parallel
  {
    const auto everyRun = [&](const auto& act) {
#pragma omp for schedule(dynamic, 1)
      for (std::size_t portion = 0; portion < portionCount; ++portion)
        for (std::size_t r = shares_[portion]; r < shares_[portion + 1]; ++r) act(r);
    };
    for (int pair = 0; pair < pairs; ++pair) {
      everyRun([&](std::size_t r) { step(r, Parity::even, pair == 0); });
      joinEnds<Parity::even>();
      everyRun([&](std::size_t r) { step(r, Parity::odd, false); });
      joinEnds<Parity::odd>();
    }
    everyRun([&](std::size_t r) { links_.arrive(r, slots(r, Parity::even)); });
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
    s.stress[k] = -(1.0 - 0.5 * evenRate(place)) * (departure[k] + 0.5 * uForce);
  }
  return s;
}

template class LatticeFlow<float>;
template class LatticeFlow<double>;

}  // namespace restenosis

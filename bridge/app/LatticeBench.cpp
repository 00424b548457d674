#include "bridge/app/LatticeBench.h"

#include <fmt/format.h>
#include <fmt/ostream.h>
#include <omp.h>

#include <algorithm>
#include <memory>
#include <ostream>
#include <set>
#include <string>
#include <vector>

#include "bridge/app/Timing.h"
#include "bridge/flow/lbm/LatticeFlow.h"
#include "bridge/surface/CylinderSurface.h"

namespace restenosis {
namespace {

constexpr double spacing = 15e-6;  // [m]
constexpr int nodesAlong = 300, nodesAcross = 130;
constexpr double relaxationTime = 0.6;
constexpr int pairsPerCall = 10;  // fewer than between two looks at the stress of a run

/// Rate at which all threads read and write 19 arrays in place, each of as many elements as the lattice has
/// places, so that no more of them fit into a cache than of the lattice [B/s].
template <class Real>
double inPlaceRate(std::size_t each) {
  std::vector<Real> values(d3q19::directions * each, Real(1));
  const double seconds = secondsPerCall([&] {
#pragma omp parallel
    {
      const std::size_t threads = omp_get_num_threads(), thread = omp_get_thread_num();
      const std::size_t begin = each * thread / threads, end = each * (thread + 1) / threads;
      Real* const first = values.data();
#pragma omp simd
      for (std::size_t i = begin; i < end; ++i) {
#pragma GCC unroll 19
        for (std::size_t d = 0; d < d3q19::directions; ++d)
          first[d * each + i] = Real(1) - first[d * each + i];
      }
    }
  });
  return 2.0 * static_cast<double>(values.size() * sizeof(Real)) / seconds;
}

struct Case {
  Case() {
    VesselParameters vessel;
    vessel.length = nodesAlong * spacing;
    vessel.lumenDiameter = nodesAcross * spacing;
    const TriSurface surface = cylinderSurface(vessel);
    lattice = std::make_unique<LumenLattice>(makeLumenLattice(surface, spacing));
    LatticeEnds ends;
    ends.inlet = LatticeEnds::Inlet::pressure;
    ends.inletDensity = 1e-3;
    boundary = makeBoundary(*lattice, surface.region, WallRule::interpolated, ends);
  }
  std::unique_ptr<LumenLattice> lattice;
  LatticeBoundary boundary;
};

struct LatticeRates {
  double updates;  ///< fluid nodes [1/s]
  double limit;    ///< at the machine's in-place rate [1/s]
};

template <class Real>
LatticeRates measure(const Case& work, int threads) {
  const int before = omp_get_max_threads();
  omp_set_num_threads(threads);
  LatticeRelaxation relaxation;
  relaxation.tau = relaxationTime;
  LatticeFlow<Real> flow(work.lattice->layout, work.boundary, relaxation);
  flow.initialise([](std::uint32_t) { return NodeState{}; });
  // The limit before and after: the machine may be shared
  const std::size_t places = work.lattice->layout.places();
  const double limitBefore = inPlaceRate<Real>(places);
  const double pair = secondsPerCall([&] { flow.advance(pairsPerCall); }) / pairsPerCall;
  const double limit = std::max(limitBefore, inPlaceRate<Real>(places));
  omp_set_num_threads(before);
  return {2.0 * static_cast<double>(work.lattice->layout.fluidNodes()) / pair, limit / flow.bytesPerNode()};
}

}  // namespace

void benchLattice(std::ostream& out) {
  const Case work;
  fmt::print(out,
             "lbm: cylinder of {} x {} x {} nodes, {:.3g} million fluid; D3Q19, two relaxation times, "
             "interpolated walls "
             "({:.2f} links a node), pressure ends\n"
             "Million fluid-node updates a second by wall clock, the best of several. The limit is the rate "
             "at which the "
             "machine updates 19 arrays of that size in place.\n\n",
             nodesAlong, nodesAcross, nodesAcross,
             1e-6 * static_cast<double>(work.lattice->layout.fluidNodes()),
             static_cast<double>(work.boundary.wall.size()) /
                 static_cast<double>(work.lattice->layout.fluidNodes()));
  fmt::print(out, "{:<12}{:>10}{:>12}{:>12}{:>12}\n", "precision", "threads", "updates", "limit", "share");
  const auto row = [&](const char* precision, int threads, const LatticeRates& r) {
    fmt::print(out, "{:<12}{:>10}{:>12.4g}{:>12.4g}{:>11.1f}%\n", precision, threads, 1e-6 * r.updates,
               1e-6 * r.limit, 100 * r.updates / r.limit);
  };
  for (const int threads : std::set<int>{1, omp_get_max_threads()}) {
    row("double", threads, measure<double>(work, threads));
    row("float", threads, measure<float>(work, threads));
  }
  fmt::print(out, "\n");
}

}  // namespace restenosis

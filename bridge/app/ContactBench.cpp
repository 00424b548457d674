#include "bridge/app/ContactBench.h"

#include <fmt/format.h>
#include <fmt/ostream.h>
#include <omp.h>

#include <algorithm>
#include <numeric>
#include <ostream>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "bridge/app/MachineLimits.h"
#include "bridge/app/Timing.h"
#include "tissue/agents/Chunks.h"
#include "tissue/equilibrium/Relaxation.h"
#include "tissue/forces/ForceField.h"
#include "tissue/vessel/WallPacking.h"

namespace restenosis {
namespace {

constexpr double wallLength = 0.55e-3;  // [m]; about 30,000 agents with the default vessel

/// The wall and how many pairs its pair kernel handles, counted from each of the two agents of a pair.
struct Workload {
  Workload() {
    VesselParameters vessel;
    vessel.length = wallLength;
    wall = packWall(vessel, mechanics, {}, 1);
    range = ForceField(mechanics).range(Relaxation::skinOverRadius * vessel.cellRadius);
    neighbours.build(wall.agents, range);
    const Index none = wall.agents.size();
    fixed = packSpheres(wall.agents, none, scale);
    exact = packSpheres(wall.agents, none);
    all.resize(wall.agents.size());
    std::iota(all.begin(), all.end(), Index{0});
    lists.resize((all.size() + PairList::capacity - 1) / PairList::capacity);
    build(lists);
    for (const Index i : all) {
      for (const Index j : neighbours.of(i)) {
        const double sum = wall.agents.radius[i] + wall.agents.radius[j];
        touching += (wall.agents.position(i) - wall.agents.position(j)).squaredNorm() < sum * sum;
      }
    }
    listed = 2.0 * static_cast<double>(neighbours.pairCount());
    bonds = 2.0 * static_cast<double>(wall.bonds.bondCount());
  }
  /// Builds the pair lists of all agents, in parallel.
  void build(std::vector<PairList>& of) const {
    const PairSource source = ForceField(mechanics).pairs(wall.agents, neighbours, wall.bonds);
    forEachChunk(all.size(), [&](std::size_t begin, std::size_t) {
      of[begin / PairList::capacity].build(source, chunk(begin), wall.agents.size());
    });
  }
  double agents() const { return static_cast<double>(all.size()); }
  std::span<const Index> chunk(std::size_t begin) const {
    return std::span(all).subspan(begin, std::min(PairList::capacity, all.size() - begin));
  }
  /// What one pass over all agents reads and writes at least, each array once [B].
  double bytes() const {
    std::size_t pairs = 0;
    for (const PairList& list : lists) pairs += list.bytes();
    return agents() * (sizeof(FixedSphere) + sizeof(AgentLoad)) + static_cast<double>(pairs);
  }

  MechanicsParameters mechanics;
  Wall wall;
  NeighbourRange range;
  NeighbourList neighbours;
  std::vector<PairList> lists;  ///< of each chunk of PairList::capacity agents
  FixedScale scale{VesselParameters().cellRadius};
  std::vector<FixedSphere> fixed;
  std::vector<Sphere> exact;
  std::vector<Index> all;
  double listed = 0, touching = 0, bonds = 0;
};

struct Rates {
  double passes;       ///< pair kernels over all agents, in mixed precision [1/s]
  double exactPasses;  ///< the same in double precision [1/s]
  double pairBuilds;   ///< pair lists of all agents [1/s]
  double builds;       ///< neighbour lists [1/s]
  MachineLimits machine;
};

/// Pair kernels over all agents a second.
template <class Spheres>
double passRate(const Workload& work, const Spheres& spheres, std::vector<AgentLoad>& load) {
  const ForceField field(work.mechanics);
  return 1 / secondsPerCall([&] {
           forEachChunk(work.all.size(), [&](std::size_t begin, std::size_t end) {
             field.evaluate(spheres, work.lists[begin / PairList::capacity], work.chunk(begin),
                            std::span(load).subspan(begin, end - begin));
           });
         });
}

Rates measure(const Workload& work, int threads) {
  const int before = omp_get_max_threads();
  omp_set_num_threads(threads);
  std::vector<AgentLoad> load(work.all.size());
  NeighbourList list;
  Rates rates{};
  rates.passes = passRate(work, FixedSpheres(work.fixed, work.scale.unit()), load);
  rates.exactPasses = passRate(work, ExactSpheres(work.exact), load);
  std::vector<PairList> lists(work.lists.size());
  rates.pairBuilds = 1 / secondsPerCall([&] { work.build(lists); });
  rates.builds = 1 / secondsPerCall([&] { list.build(work.wall.agents, work.range); });
  rates.machine = measureMachine();
  omp_set_num_threads(before);
  return rates;
}

}  // namespace

void benchContact(std::ostream& out) {
  const Workload work;
  fmt::print(
      out,
      "contact: {} agents of a packed wall; of each {:.1f} neighbours listed, {:.1f} of them touching, "
      "{:.1f} bonds\n"
      "The pair kernel computes contacts and bonds, in mixed precision as runs do unless said otherwise.\n"
      "Pairs are counted from both of their agents. Rates are by wall clock, the best of several.\n\n",
      work.all.size(), work.listed / work.agents(), work.touching / work.agents(),
      work.bonds / work.agents());

  const std::set<int> threadCounts{1, omp_get_max_threads()};
  std::vector<Rates> rates;
  std::string head = fmt::format("{:<46}", "");
  for (const int threads : threadCounts) {
    rates.push_back(measure(work, threads));
    head += fmt::format("{:>14}", fmt::format("{} thread{}", threads, threads == 1 ? "" : "s"));
  }
  fmt::print(out, "{}\n", head);
  const auto row = [&](const char* what, auto&& value) {
    std::string line = fmt::format("{:<46}", what);
    for (const Rates& r : rates) line += fmt::format("{:>14.4g}", value(r));
    fmt::print(out, "{}\n", line);
  };
  row("force evaluations [million agents/s]",
      [&](const Rates& r) { return 1e-6 * r.passes * work.agents(); });
  row("pair terms, touching [million/s]", [&](const Rates& r) { return 1e-6 * r.passes * work.touching; });
  row("pair terms, listed [million/s]", [&](const Rates& r) { return 1e-6 * r.passes * work.listed; });
  row("the same in double precision [million/s]",
      [&](const Rates& r) { return 1e-6 * r.exactPasses * work.listed; });
  row("pair lists, built again [million agents/s]",
      [&](const Rates& r) { return 1e-6 * r.pairBuilds * work.agents(); });
  row("neighbour list, built again [million agents/s]",
      [&](const Rates& r) { return 1e-6 * r.builds * work.agents(); });
  row("machine: memory copied [GB/s read + written]",
      [](const Rates& r) { return 1e-9 * r.machine.copiedBytes; });
  row("machine: multiply-add [Gflop/s]", [](const Rates& r) { return 1e-9 * r.machine.multiplyAdds; });
  row("machine: square roots [million/s]", [](const Rates& r) { return 1e-6 * r.machine.squareRoots; });
  row("pair kernel: share of the memory rate [%]",
      [&](const Rates& r) { return 100 * r.passes * work.bytes() / r.machine.copiedBytes; });
  fmt::print(out, "\n");
}

}  // namespace restenosis

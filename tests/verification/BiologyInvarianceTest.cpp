#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>

#include "tests/support/Constants.h"
#include "tests/support/RandomPacking.h"
#include "tissue/agents/StateArchive.h"
#include "tissue/biology/Biology.h"

namespace restenosis {
namespace {

using namespace support;

constexpr double side = 12 * r;

using Cell = std::tuple<double, double, double, double, CycleState, int, double, double, unsigned, double>;

std::map<AgentId, Cell> byId(const AgentStore& agents) {
  std::map<AgentId, Cell> cells;
  for (Index i = 0; i < agents.size(); ++i) {
    cells[agents.id[i]] = {agents.x[i],          agents.y[i],          agents.z[i],     agents.radius[i],
                           agents.state[i],      agents.flags[i],      agents.clock[i], agents.g1Duration[i],
                           agents.generation[i], agents.nitricOxide[i]};
  }
  return cells;
}

Biology biology() {
  BiologySettings settings;
  settings.cellCycle.emplace();
  settings.contactInhibition.emplace();
  settings.endothelium.emplace();
  settings.endothelium->scenario = "slow linear";
  settings.vesselLength = side;
  settings.seed = 4;
  return Biology(settings);
}

struct Growth {
  AgentStore agents;
  BondTable bonds;
  Biology rules = biology();
  Index divisions = 0;

  Growth() {
    support::appendRandomPacking(agents, {side, side, side}, r);
    bonds.resize(agents.size());
    rules.updateInhibition(agents);
  }
  void step(int k) {
    // A quarter of the agents sits where shear is low.
    for (Index i = 0; i < agents.size(); ++i) agents.wss[i] = agents.id[i] % 4 == 0 ? 0.1 : 1.0;
    rules.updateEndothelium(agents, k * 3600.0);
    rules.updateNitricOxide(agents);
    rules.updateInhibition(agents);
    divisions += rules.advanceCycle(agents, bonds).divisions;
  }
  void shuffle(std::uint32_t round) {
    std::vector<Index> order(agents.size());
    std::iota(order.begin(), order.end(), Index{0});
    std::ranges::sort(order, {}, [&](Index i) {
      return RandomStream(1, agents.id[i], round, RandomPurpose::packing).uniform();
    });
    agents.reorder(order);
    bonds.reorder(order);
  }
};

TEST(BiologyInvariance, NeitherOrderNorThreadsNorAResumeChangeACell) {
  Growth one, other;
  const int threads = omp_get_max_threads();
  for (int k = 1; k <= 80; ++k) {
    omp_set_num_threads(1);
    one.step(k);
    omp_set_num_threads(3);
    if (k % 10 == 0) other.shuffle(static_cast<std::uint32_t>(k));
    if (k % 16 == 0) {
      WritingArchive out;
      out(other.rules);
      other.rules = biology();
      ReadingArchive in(out.buffer());
      in(other.rules);
    }
    other.step(k);
    ASSERT_EQ(byId(one.agents), byId(other.agents)) << k;
  }
  omp_set_num_threads(threads);
  EXPECT_GT(one.divisions, 100u);
  EXPECT_EQ(one.divisions, other.divisions);
}

}  // namespace
}  // namespace restenosis

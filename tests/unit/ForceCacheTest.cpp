#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

#include "tests/support/Heap.h"
#include "tissue/equilibrium/ForceCache.h"

namespace restenosis {
namespace {

using namespace support;
using Agents = std::vector<Index>;

/// Agents in a line that touch; the first and the last are bonded. The neighbour list holds more than acts.
struct CellRow {
  AgentStore agents;
  BondTable bonds;
  ForceField field{MechanicsParameters{}};
  Constraints constraints{{}};
  NeighbourList neighbours;
  ActiveSet active;
  std::unique_ptr<ForceCache> forces;

  static constexpr Index count = 20;
  explicit CellRow(bool mixed = true) {
    for (Index i = 0; i < count; ++i) agents.append(AgentKind::smc, Vec3(1.9 * r * i, 0, 0), r);
    bonds.resize(count);
    bonds.connect(0, count - 1, 100 * r);
    active.reset(count);
    const ForceCache::Settings settings{
        .leastStiffness = 1e-3, .skin = 8 * r, .mixed = mixed ? std::optional(FixedScale(r)) : std::nullopt};
    forces = std::make_unique<ForceCache>(agents, bonds, constraints, field, neighbours, settings);
    forces->refresh();
  }
  Agents stale() { return forces->extractStale(active); }
};

TEST(ForceCache, KnowsNothingAtFirstAndAllOnceEvaluated) {
  CellRow line;
  EXPECT_EQ(line.stale().size(), CellRow::count);
  line.forces->refresh();
  EXPECT_TRUE(line.stale().empty());
}

TEST(ForceCache, IsStaleWhereAnAgentThatMovedActsOrActed) {
  for (const bool mixed : {false, true}) {
    CellRow line(mixed);
    line.stale();
    line.agents.setPosition(2, line.agents.position(5) + Vec3(0, 1.9 * r, 0));
    line.forces->refresh();
    const Agents stale = line.stale();
    for (const Index i : Agents{1, 2, 3, 5}) EXPECT_EQ(std::ranges::count(stale, i), 1) << i;
    // A move of so many radii may have come from any of its neighbours, a small one from its former partners
    line.agents.setPosition(6, line.agents.position(6) + Vec3(0, 0.01 * r, 0));
    line.forces->refresh();
    EXPECT_EQ(line.stale(), (Agents{5, 6, 7}));
  }
}

TEST(ForceCache, IsStaleWhereAnAgentGrewAndForPartnersOfBondsHoweverFar) {
  const std::vector<std::pair<Index, Agents>> expected{{3, {2, 3, 4}}, {0, {0, 1, 19}}};
  for (const auto& [grown, stale] : expected) {
    CellRow line;
    line.stale();
    line.agents.radius[grown] *= 1.01;
    line.forces->refresh();
    EXPECT_EQ(line.stale(), stale);
  }
}

TEST(ForceCache, IsStaleForNewAgentsAndThoseTheyTouch) {
  CellRow line;
  line.stale();
  line.agents.append(AgentKind::smc, Vec3(1.9 * r * 4, 1.9 * r, 0), r);
  line.bonds.resize(line.agents.size());
  line.forces->refresh();
  line.active.reset(line.agents.size());
  EXPECT_EQ(line.stale(), (Agents{4, 20}));
}

TEST(ForceCache, KnowsNothingOfAgentsInAnotherOrder) {
  CellRow line;
  line.stale();
  Agents order(CellRow::count);
  std::iota(order.begin(), order.end(), Index{0});
  std::swap(order[0], order[1]);
  line.agents.reorder(order);
  line.bonds.reorder(order);
  line.forces->refresh();
  EXPECT_EQ(line.stale().size(), CellRow::count);
}

TEST(ForceCache, LeavesOutStrutsAndActiveAgents) {
  CellRow line;
  line.agents.kind[4] = AgentKind::strut;
  line.active.add(Agents{1}, [](ActiveChunk&, std::size_t, std::size_t) {});
  const Agents stale = line.stale();
  EXPECT_EQ(stale.size(), CellRow::count - 2);
  for (const Index i : {1, 4}) EXPECT_EQ(std::ranges::count(stale, i), 0) << i;
  EXPECT_FALSE(line.forces->isFree(4));
  EXPECT_TRUE(line.forces->isFree(1));
}

/// A heap, and its forces by the plain kernel.
struct EvaluatedHeap {
  Heap heap{600};
  MechanicsParameters parameters = ofLaw("hertzNeoHookean");
  ForceField field{parameters};
  Constraints constraints{{}};
  NeighbourList neighbours;
  std::vector<AgentLoad> loads = field.evaluate(heap.agents, heap.bonds);
  double largest = 0;
  ForceCache forces{heap.agents, heap.bonds,
                    constraints, field,
                    neighbours,  {.leastStiffness = 1e-3, .skin = 0.4 * r, .mixed = FixedScale(r)}};
  ActiveSet active;

  EvaluatedHeap() {
    forces.refresh();
    active.reset(heap.agents.size());
    for (const AgentLoad& load : loads) largest = std::max(largest, load.force().norm());
  }
  void activate(const Agents& added) {
    active.add(added, [&](ActiveChunk& chunk, std::size_t n, std::size_t k) {
      const Index i = added[k];
      chunk.set(n, heap.agents.kind[i], heap.agents.position(i), heap.agents.radius[i]);
    });
  }
  void expectForce(const AgentForce& force, Index i) const {
    EXPECT_LT((Vec3(force.fx, force.fy, force.fz) - loads[i].force()).norm(), 2e-6 * largest) << i;
    EXPECT_NEAR(force.stiffness, std::max(1e-3, loads[i].stiffness), 1e-4 * force.stiffness) << i;
    EXPECT_NEAR(force.residual * force.stiffness * heap.agents.radius[i], loads[i].force().norm(),
                3e-6 * largest)
        << i;
  }
};

TEST(ForceCache, EvaluatesActiveAndInactiveAgentsAlike) {
  EvaluatedHeap at;
  AgentStore& agents = at.heap.agents;
  ForceCache& forces = at.forces;
  ActiveSet& active = at.active;
  Agents some;
  for (Index i = 0; i < agents.size(); i += 2) some.push_back(i);
  const std::vector<AgentForce> inactive = forces.evaluate(some);
  EXPECT_EQ(forces.evaluations(), some.size());

  at.activate(some);
  forces.evaluate(active);
  EXPECT_EQ(forces.evaluations(), 2 * some.size());
  for (std::size_t k = 0; k < some.size(); ++k) {
    const AgentForce force = active.chunkOf(k).force(ActiveSet::inChunk(k));
    at.expectForce(force, some[k]);
    EXPECT_EQ(force.fx, inactive[k].fx);
    EXPECT_EQ(force.residual, inactive[k].residual);
    EXPECT_EQ(forces.residual(some[k]), inactive[k].residual);
    EXPECT_EQ(agents.stress[some[k]], inactive[k].stress);
  }
}

TEST(ForceCache, FollowsAgentsThatMoveFartherThanTheSkin) {
  EvaluatedHeap at;
  AgentStore& agents = at.heap.agents;
  ForceCache& forces = at.forces;
  ActiveSet& active = at.active;
  forces.extractStale(active);
  at.activate({40});
  forces.evaluate(active);

  const Vec3 here = agents.position(40), there = agents.position(300) + Vec3(r, 0, 0);
  const Index formerPartner = at.neighbours.of(40).front();
  ASSERT_TRUE(forces.mayAct(40, formerPartner, 0));
  ActiveChunk& chunk = active.chunkOf(0);
  chunk.path[0] = static_cast<float>((there - here).norm());
  chunk.x[0] = there.x(), chunk.y[0] = there.y(), chunk.z[0] = there.z();
  forces.move(40, there, chunk.radius[0]);
  forces.updateNeighbours(active, Agents{0});
  EXPECT_EQ(agents.position(40), there);
  forces.evaluate(active);
  at.loads = at.field.evaluate(agents, at.heap.bonds);
  at.expectForce(chunk.force(0), 40);
  forces.markAround(40, chunk.path[0]);
  const Agents stale = forces.extractStale(active);
  EXPECT_EQ(std::ranges::count(stale, 300), 1);
  EXPECT_EQ(std::ranges::count(stale, formerPartner), 1) << "it is no longer listed";
}

TEST(ForceCache, NamesTheAgentOnWhichTheForceIsNotFinite) {
  CellRow line;
  line.agents.radius[3] = 1e200;
  EXPECT_THROW(
      {
        line.forces->refresh();
        line.forces->evaluate(Agents{2, 3});
      },
      std::exception);
  line.agents.radius[3] = -1;
  try {
    line.forces->refresh();
    FAIL();
  } catch (const std::invalid_argument& e) {
    EXPECT_NE(std::string(e.what()).find("agent 3 has the radius -1 m"), std::string::npos) << e.what();
  }
}

TEST(Constraints, AreAppliedInTheirOrderAndHaveTheLeastMargin) {
  struct Above : Constraint {
    explicit Above(double z) : floor(z) {}
    double floor;
    void project(AgentKind, double, Vec3& p) const override { p.z() = std::max(p.z(), floor); }
    double margin(AgentKind, double, const Vec3& p) const override { return p.z() - floor; }
    void release(AgentKind, double, const Vec3& p, Vec3& f) const override {
      if (p.z() <= floor) f.z() = std::max(f.z(), 0.0);
    }
  };
  const Above low(1), high(2);
  const std::vector<const Constraint*> both{&high, &low};
  const Constraints constraints(both);
  Vec3 place(0, 0, -5), force(1, 0, -1);
  constraints.project(AgentKind::smc, 1, place);
  EXPECT_EQ(place, Vec3(0, 0, 2));
  constraints.release(AgentKind::smc, 1, place, force);
  EXPECT_EQ(force, Vec3(1, 0, 0));
  const float margin = constraints.margin(AgentKind::smc, 1, {0, 0, 5});
  EXPECT_LE(margin, 3);
  EXPECT_NEAR(margin, 3, 1e-4);
  EXPECT_EQ(Constraints({}).margin(AgentKind::smc, 1, place), never);
}

}  // namespace
}  // namespace restenosis

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <vector>

#include "tests/support/Heap.h"
#include "tests/support/LinearContact.h"
#include "tissue/forces/ContactLawOf.h"
#include "tissue/forces/ForceField.h"
#include "tissue/forces/HertzContact.h"
#include "tissue/forces/HertzNeoHookeanContact.h"

namespace restenosis {
namespace {

using namespace support;

std::vector<Index> indicesOf(const AgentStore& agents) {
  std::vector<Index> all(agents.size());
  std::iota(all.begin(), all.end(), Index{0});
  return all;
}

/// A heap with coinciding centres, radii of 100 : 1, and the pairs of it.
struct Pairs {
  Heap heap;
  NeighbourList list;
  FixedScale scale{r};
  std::vector<Index> all;

  explicit Pairs(int count, double skin = 0.4 * r) : heap(count) {
    heap.agents.setPosition(7, heap.agents.position(8));
    heap.agents.radius[20] *= 10;
    heap.agents.radius[21] /= 10;
    all = indicesOf(heap.agents);
    build(skin);
  }
  void build(double skin) { list.build(heap.agents, ForceField(ofLaw("hertz")).range(skin)); }
  PairSource source() const { return {list, heap.bonds, heap.agents.flags, true}; }

  std::vector<AgentLoad> plainLoads(const ContactLaw& law, const MechanicsParameters& p) const {
    std::vector<AgentLoad> loads;
    for (const Index i : all) {
      std::vector<Pair> pairs;
      source().append(i, pairs);
      loads.push_back(law.plainLoad(p, heap.agents, i, pairs));
    }
    return loads;
  }
  /// The loads of some agents as kernel(list, agents, loads) has them, chunk by chunk.
  template <class Kernel>
  std::vector<AgentLoad> loadsBy(std::span<const Index> agents, const Kernel& kernel) const {
    std::vector<AgentLoad> loads(agents.size());
    PairList pairs;
    for (std::size_t begin = 0; begin < agents.size(); begin += PairList::capacity) {
      const auto chunk = agents.subspan(begin, std::min(PairList::capacity, agents.size() - begin));
      pairs.build(source(), chunk, heap.agents.size());
      kernel(pairs, chunk, std::span(loads).subspan(begin, chunk.size()));
    }
    return loads;
  }
  std::vector<AgentLoad> exactLoads(const ContactLaw& law, const MechanicsParameters& p) const {
    const auto spheres = packSpheres(heap.agents, heap.agents.size());
    return loadsBy(all, [&](const PairList& pairs, auto agents, auto loads) {
      law.evaluateExact(p, ExactSpheres(spheres), pairs, agents, loads);
    });
  }
  std::vector<AgentLoad> mixedLoads(const ContactLaw& law, const MechanicsParameters& p,
                                    std::span<const Index> agents) const {
    const auto spheres = packSpheres(heap.agents, heap.agents.size(), scale);
    return loadsBy(agents, [&](const PairList& pairs, auto chunk, auto loads) {
      law.evaluateMixed(p, FixedSpheres(spheres, scale.unit()), pairs, chunk, loads);
    });
  }
};

/// The laws of the table, and a new one.
std::vector<ContactLaw> laws() {
  std::vector<ContactLaw> all{contactLawOf<LinearContact>()};
  for (const auto name : contactLawNames()) all.push_back(contactLaw(name));
  return all;
}

double largestForce(std::span<const AgentLoad> loads) {
  double largest = 0;
  for (const AgentLoad& load : loads) largest = std::max(largest, load.force().norm());
  return largest;
}

void expectNear(std::span<const AgentLoad> loads, std::span<const AgentLoad> expected, double ofLargest,
                double ofStiffness, std::string_view law) {
  const double largest = largestForce(expected);
  double stress = 0;
  for (const AgentLoad& load : expected) stress = std::max(stress, std::abs(load.stress));
  for (std::size_t i = 0; i < loads.size(); ++i) {
    EXPECT_LT((loads[i].force() - expected[i].force()).norm(), ofLargest * largest) << law << ' ' << i;
    EXPECT_NEAR(loads[i].stress, expected[i].stress, ofLargest * stress) << law << ' ' << i;
    EXPECT_NEAR(loads[i].stiffness, expected[i].stiffness, ofStiffness * expected[i].stiffness)
        << law << ' ' << i;
  }
}

void expectSameBits(std::span<const AgentLoad> a, std::span<const AgentLoad> b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k) {
    ASSERT_EQ(a[k].force(), b[k].force()) << k;
    ASSERT_EQ(a[k].stress, b[k].stress) << k;
    ASSERT_EQ(a[k].stiffness, b[k].stiffness) << k;
  }
}

TEST(PairKernel, IsThePlainKernelUpToRounding) {
  const Pairs pairs(500);
  for (const ContactLaw& law : laws()) {
    for (const double axialFactor : {1.0, 1.5}) {
      MechanicsParameters p = ofLaw("hertz");
      p.bondAxialFactor = axialFactor;
      const auto plain = pairs.plainLoads(law, p);
      ASSERT_GT(largestForce(plain), 0);
      // Coinciding centres count as 10^-15 m apart there, and as 0 here
      expectNear(pairs.exactLoads(law, p), plain, 1e-11, 1e-9, law.name);
      const auto mixed = pairs.mixedLoads(law, p, pairs.all);
      expectNear(mixed, plain, 2e-6, 1e-4, law.name);
      Vec3 sum = Vec3::Zero();
      for (const AgentLoad& load : mixed) sum += load.force();
      EXPECT_LT(sum.norm(), 1e-6 * largestForce(plain));
    }
  }
}

TEST(PairKernel, GivesTheSameBitsForEveryListThatHoldsThePairsInRange) {
  Pairs pairs(500, 0);
  const ContactLaw law = contactLaw("hertzNeoHookean");
  const MechanicsParameters p = ofLaw(law.name);
  const auto exact = pairs.exactLoads(law, p), mixed = pairs.mixedLoads(law, p, pairs.all);
  for (const double skin : {0.1 * r, r, 5 * r}) {
    pairs.build(skin);
    expectSameBits(pairs.exactLoads(law, p), exact);
    expectSameBits(pairs.mixedLoads(law, p, pairs.all), mixed);
  }
}

TEST(PairKernel, GivesTheSameBitsForEightAndForSixteenLanes) {
  const Pairs pairs(500);
  const MechanicsParameters p = ofLaw("hertzNeoHookean");
  const auto fixed = packSpheres(pairs.heap.agents, pairs.heap.agents.size(), pairs.scale);
  const auto loadsBy = [&](const auto& spheres) {
    return pairs.loadsBy(pairs.all, [&](const PairList& list, auto agents, auto loads) {
      evaluatePairs<HertzNeoHookeanContact>(p, spheres, list, agents, loads);
    });
  };
  expectSameBits(loadsBy(FixedSpheresOf<8>(fixed, pairs.scale.unit())),
                 loadsBy(FixedSpheresOf<16>(fixed, pairs.scale.unit())));
}

TEST(PairKernel, OfAnAgentDependsNeitherOnItsPlaceNorOnTheOthersOfItsChunk) {
  Pairs pairs(300);
  const ContactLaw law = contactLaw("hertzNeoHookean");
  const MechanicsParameters p = ofLaw(law.name);
  std::vector<Index> some;
  for (const Index i : pairs.all)
    if (i % 3 == 1) some.push_back(i);
  const auto ofAll = pairs.mixedLoads(law, p, pairs.all), ofSome = pairs.mixedLoads(law, p, some);
  for (std::size_t k = 0; k < some.size(); ++k) EXPECT_EQ(ofSome[k].force(), ofAll[some[k]].force());

  // 75 m away, many periods of the scale; a whole number of its units, so that positions are rounded alike.
  const double unit = pairs.scale.unit(), away = std::ldexp(unit, 44);
  AgentStore& agents = pairs.heap.agents;
  for (auto* x : {&agents.x, &agents.y, &agents.z})
    for (double& coordinate : *x)
      coordinate = std::ldexp(unit, 6) * std::round(std::ldexp(coordinate / unit, -6));
  const auto near = pairs.mixedLoads(law, p, pairs.all);
  for (double& x : agents.x) x -= away;
  expectSameBits(pairs.mixedLoads(law, p, pairs.all), near);
}

TEST(PairKernel, OfANewLawIsTheClosedForm) {
  // Two spheres that overlap by a fifth of their radius: F = C R d
  Heap two(0);
  for (const double x : {0.0, 1.8 * r}) two.agents.append(AgentKind::smc, {x, 0, 0}, r);
  two.bonds.resize(2);
  const MechanicsParameters p = ofLaw("hertz");
  const ContactLaw law = contactLawOf<LinearContact>();
  const AgentLoad load = law.plainLoad(p, two.agents, 1, std::vector<Pair>{{0, INFINITY}});
  EXPECT_NEAR(load.fx / (p.contactModulus * r / 2 * 0.2 * r), 1, 1e-12);
  EXPECT_NEAR(load.stiffness / (p.contactModulus * r / 2), 1, 1e-12);
  EXPECT_NEAR(law.energy(p.contactModulus, 0.2 * r, r / 2) / (load.fx * 0.1 * r), 1, 1e-12);
}

}  // namespace
}  // namespace restenosis

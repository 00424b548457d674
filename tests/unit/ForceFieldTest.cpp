#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>
#include <numeric>
#include <span>
#include <vector>

#include "tests/support/Constants.h"
#include "tissue/agents/RandomStream.h"
#include "tissue/forces/ContactLaws.h"
#include "tissue/forces/ForceField.h"
#include "tissue/forces/HertzContact.h"
#include "tissue/forces/HertzNeoHookeanContact.h"
#include "tissue/forces/PairForces.h"

namespace restenosis {
namespace {

using namespace support;

/// A crowded heap with unequal radii, bonds between near agents and daughters, so that every force acts.
struct Heap {
  AgentStore agents;
  BondTable bonds;

  explicit Heap(int count = 200) {
    RandomStream random(9, 0, 0, RandomPurpose::packing);
    const double side = 1.8 * r * std::cbrt(count);
    for (int k = 0; k < count; ++k) {
      const Vec3 place = side * Vec3(random.uniform(), random.uniform(), random.uniform());
      const Index i = agents.append(AgentKind::smc, place, r * (0.7 + 0.6 * random.uniform()));
      agents.set(i, AgentFlag::daughter, k % 3 == 0);
    }
    bonds.resize(agents.size());
    for (Index i = 0; i < agents.size(); ++i) {
      for (Index j = 0; j < i; ++j) {
        const double distance = (agents.position(i) - agents.position(j)).norm();
        if (distance < 2.2 * r) bonds.connect(i, j, distance * (0.8 + 0.3 * random.uniform()));
      }
    }
  }
};

/// The loads of these agents as evaluate(rows, piece, loads) has them, piece after piece.
template <class Evaluate>
std::vector<AgentLoad> loadsInPieces(const PairSource& source, std::span<const Index> agents,
                                     const Evaluate& evaluate) {
  std::vector<AgentLoad> loads(agents.size());
  PairRows rows;
  for (std::size_t begin = 0; begin < agents.size(); begin += PairRows::most) {
    const auto piece = agents.subspan(begin, std::min(PairRows::most, agents.size() - begin));
    rows.layOut(source, piece, source.neighbours.size());
    evaluate(rows, piece, std::span(loads).subspan(begin, piece.size()));
  }
  return loads;
}

MechanicsParameters ofLaw(std::string_view law) {
  MechanicsParameters p;
  p.contactLaw = law;
  p.cohesionModulus = 0.5e6;
  return p;
}

TEST(ForceField, IsTheSlopeOfItsEnergyForEveryLaw) {
  for (const auto law : contactLawNames()) {
    const ForceField field(ofLaw(law));
    Heap heap;
    const auto loads = field.evaluate(heap.agents, heap.bonds);
    const double scale = 0.2e6 * r * r, h = 1e-5 * r;
    for (const Index i : {3u, 50u, 111u}) {
      ASSERT_GT(loads[i].force().norm(), 0.01 * scale);
      for (auto* coordinate : {&heap.agents.x, &heap.agents.y, &heap.agents.z}) {
        const double at = (*coordinate)[i];
        (*coordinate)[i] = at + h;
        const double above = field.energy(heap.agents, heap.bonds);
        (*coordinate)[i] = at - h;
        const double below = field.energy(heap.agents, heap.bonds);
        (*coordinate)[i] = at;
        const double force = coordinate == &heap.agents.x   ? loads[i].fx
                             : coordinate == &heap.agents.y ? loads[i].fy
                                                            : loads[i].fz;
        EXPECT_NEAR((below - above) / (2 * h) / scale, force / scale, 1e-4) << law;
      }
    }
  }
}

TEST(ForceField, BalancesMomentumAndMomentOfMomentum) {
  for (const auto law : contactLawNames()) {
    MechanicsParameters p = ofLaw(law);
    p.bondAxialFactor = 2;
    Heap heap;
    heap.agents.setPosition(1, heap.agents.position(0));  // coinciding centres too
    Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
    double sum = 0;
    const auto loads = ForceField(p).evaluate(heap.agents, heap.bonds);
    for (Index i = 0; i < heap.agents.size(); ++i) {
      force += loads[i].force();
      moment += heap.agents.position(i).cross(loads[i].force());
      sum += loads[i].force().norm();
    }
    EXPECT_LT(force.norm(), 1e-13 * sum);
    EXPECT_LT(moment.norm(), 1e-13 * sum * 20 * r);
  }
}

TEST(ForceField, GivesTheSameBitsForEveryListThatHoldsThePairsInRange) {
  const ForceField field(ofLaw("hertzNeoHookean"));
  Heap heap(500);
  std::vector<Index> all(heap.agents.size());
  std::iota(all.begin(), all.end(), Index{0});
  const FixedScale scale(r);
  std::vector<AgentLoad> expected[2];
  for (const double skin : {0.0, 0.1 * r, r, 5 * r}) {
    NeighbourList list;
    list.build(heap.agents, field.range(skin));
    const PairSource source{list, heap.bonds, heap.agents.flags, true};
    const auto exact = packSpheres(heap.agents, heap.agents.size());
    const auto fixed = packSpheres(heap.agents, heap.agents.size(), scale);
    for (const bool mixed : {false, true}) {
      const auto loads = loadsInPieces(source, all, [&](const auto& rows, const auto& piece, auto part) {
        if (mixed) {
          field.evaluate(FixedSpheres(fixed, scale.unit()), rows, piece, part);
        } else {
          field.evaluate(ExactSpheres(exact), rows, piece, part);
        }
      });
      if (skin == 0) expected[mixed] = loads;
      for (const Index i : all) {
        ASSERT_EQ(loads[i].force(), expected[mixed][i].force());
        ASSERT_EQ(loads[i].pressure, expected[mixed][i].pressure);
        ASSERT_EQ(loads[i].stiffness, expected[mixed][i].stiffness);
      }
    }
  }
}

TEST(ForceField, GivesTheSameBitsForEightAndForSixteenLanes) {
  const MechanicsParameters parameters = ofLaw("hertzNeoHookean");
  const ForceField field(parameters);
  Heap heap(500);
  heap.agents.setPosition(7, heap.agents.position(8));  // coinciding centres
  for (Index i = 0; i < heap.agents.size(); i += 9) heap.agents.set(i, AgentFlag::daughter, true);
  NeighbourList list;
  list.build(heap.agents, field.range(0.4 * r));
  const PairSource source{list, heap.bonds, heap.agents.flags, true};
  const FixedScale scale(r);
  const auto fixed = packSpheres(heap.agents, heap.agents.size(), scale);
  std::vector<Index> all(heap.agents.size());
  std::iota(all.begin(), all.end(), Index{0});
  const auto loadsBy = [&](const auto& spheres) {
    return loadsInPieces(source, all, [&](const auto& rows, const auto& piece, auto part) {
      evaluatePairs<HertzNeoHookeanContact>(parameters, spheres, rows, piece, part);
    });
  };
  const auto eight = loadsBy(FixedSpheresOf<8>(fixed, scale.unit()));
  const auto sixteen = loadsBy(FixedSpheresOf<16>(fixed, scale.unit()));
  for (const Index i : all) {
    ASSERT_EQ(eight[i].force(), sixteen[i].force());
    ASSERT_EQ(eight[i].pressure, sixteen[i].pressure);
    ASSERT_EQ(eight[i].stiffness, sixteen[i].stiffness);
  }
}

/// Loads in mixed precision of all agents.
std::vector<AgentLoad> mixedLoads(const ForceField& field, const AgentStore& agents, const BondTable& bonds,
                                  std::span<const Index> subset) {
  NeighbourList list;
  list.build(agents, field.range(0.4 * r));
  const FixedScale scale(r);
  const auto fixed = packSpheres(agents, agents.size(), scale);
  const PairSource source{list, bonds, agents.flags, true};
  return loadsInPieces(source, subset, [&](const auto& rows, const auto& piece, auto part) {
    field.evaluate(FixedSpheres(fixed, scale.unit()), rows, piece, part);
  });
}

TEST(ForceField, IsTheSameInMixedPrecisionUpToRounding) {
  for (const auto law : contactLawNames()) {
    MechanicsParameters p = ofLaw(law);
    p.bondAxialFactor = 1.5;
    const ForceField field(p);
    Heap heap(500);
    heap.agents.setPosition(7, heap.agents.position(8));  // coinciding centres
    heap.agents.radius[20] *= 10;
    heap.agents.radius[21] /= 10;  // 100 : 1
    std::vector<Index> all(heap.agents.size());
    std::iota(all.begin(), all.end(), Index{0});
    const auto exact = field.evaluate(heap.agents, heap.bonds);
    const auto mixed = mixedLoads(field, heap.agents, heap.bonds, all);
    Vec3 sum = Vec3::Zero();
    double largest = 0;
    for (const Index i : all) largest = std::max(largest, exact[i].force().norm());
    for (const Index i : all) {
      sum += mixed[i].force();
      EXPECT_LT((mixed[i].force() - exact[i].force()).norm(), 2e-6 * largest) << law << ' ' << i;
      EXPECT_NEAR(mixed[i].stiffness, exact[i].stiffness, 1e-4 * exact[i].stiffness) << law << ' ' << i;
    }
    EXPECT_LT(sum.norm(), 1e-6 * largest);
  }
}

TEST(ForceField, OfAnAgentDependsNeitherOnWhereItStandsNorOnWhoElseIsComputed) {
  const ForceField field(ofLaw("hertzNeoHookean"));
  Heap heap(300);
  heap.agents.setPosition(7, heap.agents.position(8));
  std::vector<Index> all(heap.agents.size()), some;
  std::iota(all.begin(), all.end(), Index{0});
  for (const Index i : all) {
    if (i % 3 == 1) some.push_back(i);
  }
  const auto ofAll = mixedLoads(field, heap.agents, heap.bonds, all);
  const auto ofSome = mixedLoads(field, heap.agents, heap.bonds, some);
  for (std::size_t k = 0; k < some.size(); ++k) EXPECT_EQ(ofSome[k].force(), ofAll[some[k]].force());

  // 75 m away, many periods of the scale; a whole number of its units, so that positions are rounded alike.
  const double away = std::ldexp(FixedScale(r).unit(), 44);
  for (const Index i : all) {
    for (auto* x : {&heap.agents.x, &heap.agents.y, &heap.agents.z})
      (*x)[i] =
          std::ldexp(FixedScale(r).unit(), 6) * std::round(std::ldexp((*x)[i] / FixedScale(r).unit(), -6));
  }
  const auto near = mixedLoads(field, heap.agents, heap.bonds, all);
  for (const Index i : all) heap.agents.x[i] -= away;
  const auto far = mixedLoads(field, heap.agents, heap.bonds, all);
  for (const Index i : all) EXPECT_EQ(near[i].force(), far[i].force());
}

TEST(ForceField, PressesTheMiddleOfAChainByItsForceOverItsArea) {
  MechanicsParameters p = ofLaw("hertz");
  AgentStore agents;
  const double spacing = 1.8 * r;
  for (int k = 0; k < 3; ++k) agents.append(AgentKind::smc, {k * spacing, 0, 0}, r);
  BondTable bonds;
  bonds.resize(3);
  const auto loads = ForceField(p).evaluate(agents, bonds);
  const double force = forceOf(HertzContact(p.contactModulus), 0.2 * r, r / 2);
  const double volume = 4.0 / 3.0 * std::numbers::pi * r * r * r;
  EXPECT_NEAR(loads[1].pressure / (spacing * force / (3 * volume)), 1, 1e-12);
  EXPECT_NEAR(loads[0].pressure / loads[1].pressure, 0.5, 1e-12);
  EXPECT_NEAR(loads[0].fx / -force, 1, 1e-12);
}

TEST(ForceField, PullsNegativePressureOnABond) {
  AgentStore agents;
  for (int k = 0; k < 2; ++k) agents.append(AgentKind::smc, {0, 0, k * 2.5 * r}, r);
  BondTable bonds;
  bonds.resize(2);
  bonds.connect(0, 1, 2 * r);
  const auto loads = ForceField(MechanicsParameters{}).evaluate(agents, bonds);
  EXPECT_LT(loads[0].pressure, 0);
  EXPECT_NEAR(loads[0].fz / (2.18e6 * 0.25 * 4 * r * r), 1, 1e-6);  // rest lengths are floats
}

TEST(ForceField, CohesionIsForDaughtersOnly) {
  AgentStore agents;
  for (int k = 0; k < 2; ++k) agents.append(AgentKind::smc, {0, 0, k * 2.1 * r}, r);
  BondTable bonds;
  bonds.resize(2);
  const ForceField field{MechanicsParameters{}};
  EXPECT_EQ(field.evaluate(agents, bonds)[0].fz, 0);
  agents.set(1, AgentFlag::daughter, true);
  EXPECT_GT(field.evaluate(agents, bonds)[0].fz, 0);
  EXPECT_EQ(field.evaluate(agents, bonds)[0].fz, -field.evaluate(agents, bonds)[1].fz);
}

TEST(ForceField, PushesCoincidingCentresApart) {
  for (const auto law : contactLawNames()) {
    AgentStore agents;
    agents.append(AgentKind::smc, {1e-4, 2e-4, 3e-4}, r);
    agents.append(AgentKind::smc, {1e-4, 2e-4, 3e-4}, r / 100);
    BondTable bonds;
    bonds.resize(2);
    const auto loads = ForceField(ofLaw(law)).evaluate(agents, bonds);
    EXPECT_GT(loads[0].force().norm(), 0);
    EXPECT_TRUE(loads[0].force().allFinite());
    EXPECT_EQ(loads[0].force(), -loads[1].force());
  }
}

TEST(ForceField, CountsWhomTheContactLawDoesNotHoldFor) {
  // A small cell in the middle of a large one, two that touch, and a strut inside another large one.
  AgentStore agents;
  const auto add = [&](AgentKind kind, double x, double radius) {
    agents.append(kind, Vec3(x * r, 0, 0), radius * r);
  };
  add(AgentKind::smc, 0, 5), add(AgentKind::smc, 0.5, 1);
  add(AgentKind::smc, 20, 1), add(AgentKind::smc, 21.9, 1);
  add(AgentKind::smc, 40, 5), add(AgentKind::strut, 40, 1);
  const auto beyond = [&](std::string_view law) { return ForceField(ofLaw(law)).agentsBeyondLaw(agents); };
  EXPECT_EQ(beyond("hertzNeoHookean"), 3u);
  EXPECT_EQ(beyond("hertz"), 0u);
}

TEST(ForceField, CountsThemAsAComparisonOfAllPairsDoes) {
  RandomStream random(7, 0, 0, RandomPurpose::packing);
  AgentStore agents;
  for (int n = 0; n < 400; ++n) {
    const double x = random.uniform(), y = random.uniform(), z = random.uniform();
    agents.append(AgentKind::smc, 20 * r * Vec3(x, y, z), r * (1 + 3 * random.uniform()));
  }
  const ContactLaw& law = contactLaw("hertzNeoHookean");
  Index expected = 0;
  for (Index i = 0; i < agents.size(); ++i) {
    bool beyond = false;
    for (Index j = 0; j < agents.size(); ++j) {
      const double radii = agents.radius[i] + agents.radius[j];
      const double overlap = radii - (agents.position(i) - agents.position(j)).norm();
      beyond |= j != i && overlap > law.validOverlap(agents.radius[i] * agents.radius[j] / radii);
    }
    expected += beyond;
  }
  EXPECT_GT(expected, 0u);
  EXPECT_LT(expected, 400u);
  EXPECT_EQ(ForceField(ofLaw("hertzNeoHookean")).agentsBeyondLaw(agents), expected);
}

TEST(ForceField, SetsThePressureOfAllButStruts) {
  AgentStore agents;
  agents.append(AgentKind::smc, {0, 0, 0}, r);
  agents.append(AgentKind::iel, {1.5 * r, 0, 0}, r);
  agents.append(AgentKind::strut, {0, 1.5 * r, 0}, r);
  BondTable bonds;
  bonds.resize(3);
  const ForceField field(ofLaw("hertz"));
  const auto loads = field.evaluate(agents, bonds);
  field.setPressures(agents, bonds);
  EXPECT_GT(loads[0].pressure, loads[1].pressure);
  EXPECT_EQ(agents.pressure, (std::vector<double>{loads[0].pressure, loads[1].pressure, 0}));
}

}  // namespace
}  // namespace restenosis

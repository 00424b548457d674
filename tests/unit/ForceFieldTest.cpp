#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>
#include <vector>

#include "tests/support/Constants.h"
#include "tests/support/Heap.h"
#include "tissue/agents/RandomStream.h"
#include "tissue/forces/ContactLaws.h"
#include "tissue/forces/ForceField.h"
#include "tissue/forces/HertzContact.h"
#include "tissue/forces/HertzNeoHookeanContact.h"

namespace restenosis {
namespace {

using namespace support;

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
  EXPECT_NEAR(loads[1].stress / (spacing * force / (3 * volume)), 1, 1e-12);
  EXPECT_NEAR(loads[0].stress / loads[1].stress, 0.5, 1e-12);
  EXPECT_NEAR(loads[0].fx / -force, 1, 1e-12);
}

TEST(ForceField, PullsNegativePressureOnABond) {
  AgentStore agents;
  for (int k = 0; k < 2; ++k) agents.append(AgentKind::smc, {0, 0, k * 2.5 * r}, r);
  BondTable bonds;
  bonds.resize(2);
  bonds.connect(0, 1, 2 * r);
  const auto loads = ForceField(MechanicsParameters{}).evaluate(agents, bonds);
  EXPECT_LT(loads[0].stress, 0);
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

TEST(ForceField, CountsAgentsThatTheContactLawDoesNotHoldFor) {
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
  field.setStresses(agents, bonds);
  EXPECT_GT(loads[0].stress, loads[1].stress);
  EXPECT_EQ(agents.stress, (std::vector<double>{loads[0].stress, loads[1].stress, 0}));
}

}  // namespace
}  // namespace restenosis

#include <gtest/gtest.h>

#include <vector>

#include "tissue/agents/StateArchive.h"
#include "tissue/biology/ReferenceConfiguration.h"

namespace restenosis {
namespace {

constexpr double unit = 1.0;

AgentStore row(int n) {
  AgentStore agents;
  for (int k = 0; k < n; ++k) agents.append(AgentKind::smc, Vec3(10.0 * k, 0, 0), unit);
  return agents;
}

std::vector<double> places(const std::vector<DisturbedPlace>& disturbed) {
  std::vector<double> x;
  for (const auto& place : disturbed) x.push_back(place.centre.x());
  return x;
}

TEST(ReferenceConfiguration, ReportsNewAgentsOnce) {
  ReferenceConfiguration reference;
  AgentStore agents = row(2);
  EXPECT_EQ(places(reference.follow(agents, 0.1)), (std::vector<double>{0, 10}));
  EXPECT_TRUE(reference.follow(agents, 0.1).empty());
  agents.append(AgentKind::smc, Vec3(50, 0, 0), unit);
  EXPECT_EQ(places(reference.follow(agents, 0.1)), (std::vector<double>{50}));
}

TEST(ReferenceConfiguration, NoticesSlowMotionAndGrowthOnceTheyAddUp) {
  ReferenceConfiguration reference;
  AgentStore agents = row(2);
  reference.follow(agents, 0.1);
  agents.x[0] = 0.06;
  EXPECT_TRUE(reference.follow(agents, 0.1).empty());
  EXPECT_EQ(reference.shapes().x[0], 0.0);
  agents.x[0] = 0.12;
  EXPECT_EQ(places(reference.follow(agents, 0.1)), (std::vector<double>{0.06}));
  agents.radius[1] = 1.05;
  EXPECT_TRUE(reference.follow(agents, 0.1).empty());
  agents.radius[1] = 1.15;
  EXPECT_EQ(places(reference.follow(agents, 0.1)), (std::vector<double>{10}));
  agents.x[0] = 5;
  EXPECT_EQ(places(reference.follow(agents, 0.1)), (std::vector<double>{0.12, 5}));
}

TEST(ReferenceConfiguration, NamesPlacesThatHoldWhereAnAgentWasAndIs) {
  ReferenceConfiguration reference;
  AgentStore agents = row(1);
  reference.follow(agents, 0.1);
  const Vec3 before = agents.position(0), after(0.3, 0.2, 0.1);
  agents.setPosition(0, after);
  agents.radius[0] = 1.2;
  const auto disturbed = reference.follow(agents, 0.1);
  ASSERT_EQ(disturbed.size(), 1u);
  EXPECT_GE(disturbed[0].radius, (before - disturbed[0].centre).norm() + unit - 1e-12);
  EXPECT_GE(disturbed[0].radius, (after - disturbed[0].centre).norm() + 1.2 - 1e-12);
}

TEST(ReferenceConfiguration, FollowsOrderBirthAndRemovalById) {
  ReferenceConfiguration reference;
  AgentStore agents = row(4);
  reference.follow(agents, 0.1);
  for (Index i = 0; i < 4; ++i) reference.marks()[i] = static_cast<std::uint8_t>(i + 1);
  agents.erase(std::vector<std::uint8_t>{0, 1, 0, 0});
  agents.append(AgentKind::smc, Vec3(70, 0, 0), unit);
  agents.reorder(std::vector<Index>{3, 2, 0, 1});
  EXPECT_EQ(places(reference.follow(agents, 0.1)), (std::vector<double>{10, 70}));
  const auto marks = reference.marks();
  EXPECT_EQ(std::vector<int>(marks.begin(), marks.end()), (std::vector<int>{0, 4, 1, 3}));
  EXPECT_TRUE(std::ranges::equal(reference.shapes().x, agents.x));
}

TEST(ReferenceConfiguration, TakesOnAnOrderItIsTold) {
  ReferenceConfiguration reference;
  AgentStore agents = row(4);
  reference.follow(agents, 0.1);
  reference.marks()[2] = 7;
  const std::vector<Index> order{3, 2, 0, 1};
  agents.reorder(order);
  reference.reorder(order);
  EXPECT_TRUE(std::ranges::equal(reference.shapes().x, agents.x));
  EXPECT_EQ(reference.marks()[1], 7);
  agents.append(AgentKind::smc, Vec3(50, 0, 0), unit);
  EXPECT_EQ(places(reference.follow(agents, 0.1)), (std::vector<double>{50}));
  // One that is not of these agents is as if it had not been told
  reference.reorder(order);
  EXPECT_TRUE(reference.follow(agents, 0.1).empty());
}

TEST(ReferenceConfiguration, SurvivesAnArchive) {
  ReferenceConfiguration reference, restored;
  AgentStore agents = row(3);
  reference.follow(agents, 0.1);
  WritingArchive out;
  out(reference);
  ReadingArchive in(out.buffer());
  in(restored);
  EXPECT_TRUE(restored.follow(agents, 0.1).empty());
}

}  // namespace
}  // namespace restenosis

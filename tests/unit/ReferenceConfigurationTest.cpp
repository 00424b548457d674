#include <gtest/gtest.h>

#include <vector>

#include "ReferenceConfiguration.h"
#include "StateArchive.h"

namespace restenosis {
namespace {

constexpr double r = 1.0;

AgentStore row(int n) {
  AgentStore agents;
  for (int k = 0; k < n; ++k) agents.append(AgentKind::smc, Vec3(10.0 * k, 0, 0), r);
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
  agents.append(AgentKind::smc, Vec3(50, 0, 0), r);
  EXPECT_EQ(places(reference.follow(agents, 0.1)), (std::vector<double>{50}));
}

TEST(ReferenceConfiguration, NoticesSlowMotionAndGrowthOnceTheyAddUp) {
  ReferenceConfiguration reference;
  AgentStore agents = row(2);
  reference.follow(agents, 0.1);
  agents.x[0] = 0.06;
  EXPECT_TRUE(reference.follow(agents, 0.1).empty());
  EXPECT_EQ(reference.agents().x[0], 0.0);
  agents.x[0] = 0.12;
  EXPECT_EQ(places(reference.follow(agents, 0.1)), (std::vector<double>{0, 0.12}));
  agents.radius[1] = 1.05;
  EXPECT_TRUE(reference.follow(agents, 0.1).empty());
  agents.radius[1] = 1.15;
  EXPECT_EQ(places(reference.follow(agents, 0.1)), (std::vector<double>{10, 10}));
}

TEST(ReferenceConfiguration, FollowsOrderBirthAndRemovalById) {
  ReferenceConfiguration reference;
  AgentStore agents = row(4);
  reference.follow(agents, 0.1);
  for (Index i = 0; i < 4; ++i) reference.marks()[i] = static_cast<std::uint8_t>(i + 1);
  agents.erase(std::vector<std::uint8_t>{0, 1, 0, 0});
  agents.append(AgentKind::smc, Vec3(70, 0, 0), r);
  agents.reorder(std::vector<Index>{3, 2, 0, 1});
  EXPECT_EQ(places(reference.follow(agents, 0.1)), (std::vector<double>{10, 70}));
  const auto marks = reference.marks();
  EXPECT_EQ(std::vector<int>(marks.begin(), marks.end()), (std::vector<int>{0, 4, 1, 3}));
  EXPECT_EQ(reference.agents().id, agents.id);
  EXPECT_EQ(reference.agents().x, agents.x);
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

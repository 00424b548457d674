#include <gtest/gtest.h>

#include "tests/support/SmallDeployment.h"
#include "tissue/agents/StateArchive.h"
#include "tissue/stent/Deployment.h"
#include "tissue/stent/StrutAgents.h"
#include "tissue/vessel/Cylindrical.h"
#include "tissue/vessel/WallBonds.h"
#include "tissue/vessel/WallPacking.h"

namespace restenosis {
namespace {

using Setting = support::SmallDeployment;

Wall packedWall() {
  static const Wall wall = packWall(Setting().vessel, Setting().mechanics, Setting().relaxation, 1);
  return wall;
}

std::string digest(Wall wall) {
  HashingArchive archive;
  archive(wall);
  return archive.digest();
}

class Deployed : public ::testing::TestWithParam<const char*> {};

TEST_P(Deployed, KeepsTheWallTogether) {
  Setting s;
  s.stent.outerLamina = GetParam();
  Wall wall = packedWall();
  const Index wallAgents = wall.agents.size();
  Deployment deployment(wall, stentOfDesign(s.stent, s.vessel), s.stent, s.vessel, s.mechanics, s.relaxation);
  int reports = 0;
  deployment.run([&](const Deployment&, const RelaxationReport& report) {
    EXPECT_TRUE(report.converged);
    ++reports;
    EXPECT_LE(report.residual, s.relaxation.tolerance);
  });
  EXPECT_EQ(reports, 20);

  double outermost = 0;
  Index struts = 0;
  for (Index i = 0; i < wall.agents.size(); ++i) {
    ASSERT_GE(wall.agents.z[i], 0);
    ASSERT_LE(wall.agents.z[i], s.vessel.length);
    if (wall.agents.kind[i] != AgentKind::strut) continue;
    outermost = std::max(outermost, radiusOf(wall.agents.position(i)) + wall.agents.radius[i]);
    ++struts;
  }
  EXPECT_NEAR(outermost, 0.26e-3, 0.1e-6);
  EXPECT_EQ(wall.agents.size(), wallAgents + struts);

  const DeploymentStatistics statistics = deployment.statistics();
  EXPECT_EQ(statistics.escaped, 0u);
  EXPECT_EQ(statistics.outside, 0u);
  EXPECT_GT(statistics.ielUnderStrut.value(), 0.26e-3);
  EXPECT_LT(statistics.ielUnderStrut.value(), 0.28e-3);
  EXPECT_LT(statistics.laminaDistance.value(), 0.16e-3);
  EXPECT_GT(statistics.laminaDistance.value(), 0.09e-3);
  EXPECT_LT(statistics.largestOverlap, 2);
  EXPECT_GT(statistics.largestIelStrain, 0.05);
}

INSTANTIATE_TEST_SUITE_P(Eel, Deployed, ::testing::Values("free", "fixed"),
                         [](const auto& outer) { return std::string(outer.param); });

TEST(DeploymentTest, NamesTheToleranceThatTheIterationsDidNotReach) {
  Setting s;
  s.stent.deploymentSteps = 5;
  s.relaxation.maximumIterations = 10;
  Wall wall = packedWall();
  Deployment deployment(wall, stentOfDesign(s.stent, s.vessel), s.stent, s.vessel, s.mechanics, s.relaxation);
  try {
    deployment.run();
    FAIL();
  } catch (const RelaxationFailed& failure) {
    EXPECT_NE(std::string(failure.what()).find("relaxation.tolerance = 0.003"), std::string::npos)
        << failure.what();
  }
}

TEST(DeploymentTest, EelFixedDoesNotMove) {
  Setting s;
  s.stent.outerLamina = "fixed";
  s.stent.deploymentSteps = 20;
  Wall wall = packedWall();
  const Wall before = wall;
  Deployment deployment(wall, stentOfDesign(s.stent, s.vessel), s.stent, s.vessel, s.mechanics, s.relaxation);
  for (int k = 0; k < 3; ++k) deployment.step();
  for (Index i = 0; i < before.agents.size(); ++i) {
    if (before.agents.kind[i] == AgentKind::eel || before.agents.has(i, fixed)) {
      ASSERT_EQ(wall.agents.position(i), before.agents.position(i));
    }
  }
}

TEST(DeploymentTest, ResumesBitForBit) {
  const Setting s;
  Wall whole = packedWall();
  Deployment uninterrupted(whole, stentOfDesign(s.stent, s.vessel), s.stent, s.vessel, s.mechanics,
                           s.relaxation);
  for (int k = 0; k < 4; ++k) uninterrupted.step();

  Wall halted = packedWall();
  {
    Deployment first(halted, stentOfDesign(s.stent, s.vessel), s.stent, s.vessel, s.mechanics, s.relaxation);
    for (int k = 0; k < 2; ++k) first.step();
  }
  WritingArchive written;
  written(halted);
  ReadingArchive reading(written.buffer());
  Wall resumed;
  reading(resumed);
  Deployment second(resumed, stentOfDesign(s.stent, s.vessel), s.stent, s.vessel, s.mechanics, s.relaxation,
                    2);
  for (int k = 0; k < 2; ++k) second.step();
  EXPECT_EQ(digest(resumed), digest(whole));
}

TEST(DeploymentTest, StrutsOfAnotherStentAreRefused) {
  Setting s;
  Wall wall = packedWall();
  Deployment first(wall, stentOfDesign(s.stent, s.vessel), s.stent, s.vessel, s.mechanics, s.relaxation);
  s.stent.strutWidth = 0.05e-3;
  EXPECT_THROW(
      Deployment(wall, stentOfDesign(s.stent, s.vessel), s.stent, s.vessel, s.mechanics, s.relaxation),
      std::invalid_argument);
}

/// Without bonds the wall is a liquid: the IEL gives way to the strut sideways and bulges into the lumen.
TEST(DeploymentTest, BondsHoldTheIelUnderTheStrut) {
  Setting s;
  s.stent.outerLamina = "fixed";
  const auto ielUnderStrut = [&](bool bonded) {
    Wall wall = packedWall();
    if (!bonded) bondWall(wall, 0);
    Deployment deployment(wall, stentOfDesign(s.stent, s.vessel), s.stent, s.vessel, s.mechanics,
                          s.relaxation);
    deployment.run();
    int under = 0;
    for (Index i = 0; i < wall.agents.size(); ++i) {
      under += wall.agents.kind[i] == AgentKind::iel &&
               std::abs(wall.agents.z[i] - s.vessel.length / 2) < s.stent.strutWidth / 2;
    }
    return under;
  };
  EXPECT_GT(ielUnderStrut(true), 1.25 * ielUnderStrut(false));
}

}  // namespace
}  // namespace restenosis

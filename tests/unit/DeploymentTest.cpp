#include <gtest/gtest.h>

#include "tests/support/Constants.h"
#include "tests/support/SmallDeployment.h"
#include "tissue/stent/Deployment.h"
#include "tissue/stent/StrutAgents.h"
#include "tissue/vessel/Cylindrical.h"

namespace restenosis {
namespace {

using namespace support;

/// A stent in a wall of three agents that it does not reach.
struct SparseDeployment : testing::Test {
  SparseDeployment() {
    wall = emptyWall(setup.vessel);
    cell = add(AgentKind::smc, 0.30e-3, 0.15e-3);
    eel = add(AgentKind::eel, 0.385e-3, 0.15e-3);
    end = add(AgentKind::smc, 0.30e-3, 0);
    wall.bonds.resize(wall.agents.size());
  }
  Index add(AgentKind kind, double fromAxis, double z) {
    return wall.agents.append(kind, {fromAxis, 0, z}, setup.vessel.cellRadius);
  }
  Stent stent() const { return stentOfDesign(setup.stent, setup.vessel); }
  Deployment deployment(int stepsDone = 0) {
    return {wall, stent(), setup.stent, setup.vessel, setup.mechanics, setup.relaxation, stepsDone};
  }
  bool isFixed(Index i) const { return wall.agents.has(i, fixed); }
  double outermostStrut() const {
    double outermost = 0;
    for (Index i = 0; i < wall.agents.size(); ++i)
      if (wall.agents.kind[i] == AgentKind::strut)
        outermost = std::max(outermost, radiusOf(wall.agents.position(i)) + wall.agents.radius[i]);
    return outermost;
  }
  SmallDeployment setup;
  Wall wall;
  Index cell, eel, end;
};

TEST_F(SparseDeployment, AppendsFixedStruts) {
  const Index before = wall.agents.size();
  const Deployment at = deployment();
  ASSERT_EQ(wall.agents.size(), before + stent().spheres.size());
  EXPECT_EQ(wall.bonds.size(), wall.agents.size());
  for (Index i = before; i < wall.agents.size(); ++i) {
    EXPECT_EQ(wall.agents.kind[i], AgentKind::strut);
    EXPECT_TRUE(isFixed(i));
  }
  EXPECT_NEAR(outermostStrut(), 0.2e-3, 1e-9) << "at the lumen's surface";
}

TEST_F(SparseDeployment, FixesEndsAndAFixedOuterLamina) {
  deployment();
  EXPECT_TRUE(isFixed(end));
  EXPECT_FALSE(isFixed(cell) || isFixed(eel));
  setup.stent.outerLamina = "fixed";
  deployment();
  EXPECT_TRUE(isFixed(eel));
  EXPECT_FALSE(isFixed(cell));
}

TEST_F(SparseDeployment, MovesTheStentInEqualSteps) {
  Deployment at = deployment();
  const Vec3 before = wall.agents.position(cell);
  for (const int k : {0, 5, 20}) EXPECT_NEAR(at.depthAfter(k), 60e-6 * k / 20, 1e-18);
  at.step();
  EXPECT_EQ(at.stepsDone(), 1);
  EXPECT_NEAR(outermostStrut(), 0.2e-3 + 3e-6, 1e-9);
  int reports = 0;
  at.run([&](const Deployment& now, const RelaxationReport& report) {
    EXPECT_EQ(now.stepsDone(), 2 + reports++);
    EXPECT_TRUE(report.converged);
  });
  EXPECT_EQ(reports, 19);
  EXPECT_TRUE(at.done());
  EXPECT_NEAR(outermostStrut(), 0.2e-3 + 60e-6, 1e-9);
  EXPECT_EQ(wall.agents.position(cell), before) << "no strut has reached it";
}

TEST_F(SparseDeployment, ContinuesWithTheStrutsOfAWallReadBack) {
  deployment().step();
  const Index count = wall.agents.size();
  wall.agents.set(cell, fixed, true);
  Deployment later = deployment(1);
  EXPECT_EQ(wall.agents.size(), count);
  EXPECT_TRUE(isFixed(cell)) << "flags are set before the first step only";
  later.step();
  EXPECT_EQ(later.stepsDone(), 2);
  EXPECT_NEAR(outermostStrut(), 0.2e-3 + 6e-6, 1e-9);
  setup.stent.strutWidth *= 2;
  EXPECT_THROW(deployment(2), std::invalid_argument) << "struts of another stent";
}

}  // namespace
}  // namespace restenosis

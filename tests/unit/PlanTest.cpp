#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>

#include "bridge/coupling/CostForecast.h"
#include "bridge/coupling/FidelityError.h"
#include "bridge/coupling/Instant.h"
#include "bridge/coupling/Plan.h"
#include "bridge/scene/LoadedWall.h"
#include "bridge/scene/SceneChecks.h"
#include "bridge/surface/SceneStent.h"
#include "bridge/surface/StlFile.h"
#include "tests/support/SweptTube.h"
#include "tests/support/TemporaryFolder.h"
#include "tests/support/TubeSurface.h"
#include "tissue/parameters/SecondsPerDay.h"
#include "tissue/vessel/WallPacking.h"

namespace restenosis {
namespace {

TEST(Plan, CountsTheAgentsOfALoadedWall) {
  const TemporaryFolder folder;
  Scene scene;
  scene.mechanics.emplace();
  scene.vessel.agents = (folder.path() / "w.csv").string();
  writeText(scene.vessel.agents, "x,y,z,radius\n915,0,100,15\n945,0,100,15\n975,0,100,15\n");
  const std::string text = planText(scene);
  EXPECT_NE(text.find("loaded as it stands from " + scene.vessel.agents), std::string::npos) << text;
  EXPECT_NE(text.find("\n3 agents, "), std::string::npos) << text;
}

TEST(Plan, CallsTheIelIntactOnlyOfAPackedWall) {
  const TemporaryFolder folder;
  Scene scene;
  scene.scene.duration = 5 * secondsPerDay;
  scene.mechanics.emplace();
  scene.cellCycle.emplace();
  scene.endothelium.emplace();
  scene.flow.emplace().backend = "analytic";
  EXPECT_NE(planText(scene).find("the IEL is intact"), std::string::npos) << planText(scene);
  scene.vessel.agents = (folder.path() / "w.csv").string();
  writeText(scene.vessel.agents, "x,y,z,radius\n915,0,100,15\n945,0,100,15\n");
  EXPECT_EQ(planText(scene).find("the IEL is intact"), std::string::npos) << planText(scene);
}

TEST(Plan, EstimatesTheAgentsOfAPackedWall) {
  Scene scene;
  scene.mechanics.emplace();
  EXPECT_NE(planText(scene).find("\nabout 248"), std::string::npos) << planText(scene);
}

TEST(Plan, CountsTheAgentsOfAWallAroundALoadedLumen) {
  const TemporaryFolder folder;
  TriSurface bulge = support::tube(0.4e-3, 2e-3);
  for (Vec3& v : bulge.vertices) v.head<2>() *= 1 + std::sin(std::numbers::pi * v.z() / 2e-3);
  Scene scene;
  scene.mechanics.emplace();
  scene.vessel.lumenSurface = folder / "bulge.stl";
  writeStl(scene.vessel.lumenSurface, bulge, 1e-3);
  scene.vessel.length = 2e-3;
  scene.vessel.lumenDiameter = 0.8e-3;
  const auto made = scatterWall(scene.vessel, loadedWallShape(scene.vessel), 1).agents.size();
  EXPECT_GT(made, 1.4 * estimatedAgents(scene)) << "what a cylinder of the inlet's width would have";
  EXPECT_NE(planText(scene).find(fmt::format("\nabout {} agents, ", made)), std::string::npos)
      << planText(scene);
}

TEST(Plan, EstimatesTheCellsOfALoadedLumenByItsOwnSize) {
  const TemporaryFolder folder;
  // A bow, whose ends are much nearer to each other than it is long
  std::vector<support::AxisPoint> axis;
  for (int k = 0; k <= 60; ++k) {
    const double turn = 1.5 * std::numbers::pi * k / 60;
    axis.push_back(
        {3e-3 * Vec3(1 - std::cos(turn), 0, std::sin(turn)), Vec3(std::sin(turn), 0, std::cos(turn))});
  }
  Scene scene;
  scene.scene.fidelity = "draft";
  scene.flow.emplace().backend = "foam";
  scene.vessel.lumenSurface = folder / "bow.stl";
  writeStl(scene.vessel.lumenSurface, support::sweptTube(axis, 0.9e-3), 1e-3);
  scene.vessel.length = 4.2e-3;  // between the ends
  const std::string text = planText(scene);
  const double cells = std::stod(text.substr(text.find("; about ") + 8));
  EXPECT_NEAR(cells, 241256 * 14.1 / 32, 0.06 * 241256 * 14.1 / 32)
      << "a spring as wide, of which 32 mm were meshed";
}

TEST(Plan, CountsStrutsAmongTheAgents) {
  Scene scene;
  scene.mechanics.emplace();
  scene.stent.emplace();
  const auto spheres = makeStent(*scene.stent, scene.vessel).spheres.size();
  EXPECT_NE(planText(scene).find(fmt::format("agents ({} of them struts), ", spheres)), std::string::npos)
      << planText(scene);
}

TEST(Plan, EstimatesTheOneSolveOfALumenWithoutTissue) {
  Scene scene;
  EXPECT_NE(planText(scene).find("\nno agents, no flow\n"), std::string::npos) << planText(scene);
  scene.flow.emplace().backend = "foam";
  // checkMesh counts 109,200 in `poiseuille`, which is this tube
  EXPECT_NE(planText(scene).find("\nno agents; about 1.1e+05 cells, "), std::string::npos) << planText(scene);
  scene.flow->backend = "lbm";
  EXPECT_NE(planText(scene).find(" lattice nodes, "), std::string::npos) << planText(scene);
}

TEST(Plan, SaysWhatTheFlowOfGrowingTissueIsLikelyToTake) {
  Scene scene;
  scene.scene.duration = 10 * secondsPerDay;
  scene.scene.step = 3600;
  scene.mechanics.emplace();
  scene.cellCycle.emplace();
  scene.endothelium.emplace().scenario = "3-23 days";
  scene.flow.emplace().backend = "foam";
  scene.coupling.lumenTolerance = 20e-6;
  // From day 3 to day 10
  EXPECT_NE(planText(scene).find(" a solve; 5 to 9 solves are likely: "), std::string::npos)
      << planText(scene);
  scene.activation.emplace();
  EXPECT_NE(planText(scene).find(" a solve; 10 to 21 solves are likely: "), std::string::npos)
      << planText(scene);
  scene.coupling.lumenInterval = 12 * 3600;
  EXPECT_NE(planText(scene).find(" a solve; 10 to 15 solves are likely: "), std::string::npos)
      << planText(scene);
  scene.activation.reset();
  scene.coupling.lumenInterval = 0;
  scene.coupling.lumenTolerance = 5e-6;
  EXPECT_NE(planText(scene).find(" a solve; 34 to 169 solves are likely: "), std::string::npos)
      << planText(scene);
  scene.coupling.lumenTolerance = 0;
  EXPECT_NE(planText(scene).find(" a solve; 169 solves are likely: "), std::string::npos) << planText(scene);
  scene.coupling.schedule = "everyStep";
  EXPECT_NE(planText(scene).find(" a solve; 241 solves are likely: "), std::string::npos) << planText(scene);
}

TEST(Plan, SaysHowFarTheFidelityIsOffWhereThatWasMeasured) {
  Scene scene;
  scene.scene.duration = 28 * secondsPerDay;
  scene.scene.step = 3600;
  scene.mechanics.emplace();
  scene.cellCycle.emplace();
  scene.stent.emplace();
  scene.endothelium.emplace();
  scene.flow.emplace().backend = "foam";
  scene.scene.fidelity = "draft";
  EXPECT_EQ(fidelityErrorText(scene), "");  // the tolerance of another fidelity
  scene.coupling = CouplingParameters::forFidelity("draft");
  const auto draft = fidelityError(scene);
  ASSERT_TRUE(draft);
  EXPECT_NE(planText(scene).find("\nerror: neointimal area at draft: "), std::string::npos)
      << planText(scene);
  EXPECT_EQ(nlohmann::json::parse(planJson(scene))["error"]["neointimaArea"], draft->area);
  Scene other = scene;
  other.vessel.cellRadius = 40e-6;
  EXPECT_EQ(fidelityErrorText(other), "");
  other = scene;
  other.flow->backend = "lbm";
  EXPECT_EQ(fidelityErrorText(other), "");
  other = scene;
  other.foam.emplace();
  EXPECT_EQ(fidelityErrorText(other), "");
  scene.scene.fidelity = "reference";
  scene.coupling = CouplingParameters::forFidelity("reference");
  EXPECT_EQ(fidelityError(scene)->area, 0);
}

TEST(Plan, AsJsonHasTheSameNumbers) {
  Scene scene;
  scene.scene.duration = 5 * secondsPerDay;
  scene.scene.title = "a \xff byte that is no text";
  EXPECT_TRUE(nlohmann::json::parse(planJson(scene))["tissue"].is_null());
  EXPECT_TRUE(nlohmann::json::parse(planJson(scene))["flow"].is_null());
  scene.mechanics.emplace();
  scene.cellCycle.emplace();
  scene.endothelium.emplace();
  scene.flow.emplace().backend = "lbm";
  const auto plan = nlohmann::json::parse(planJson(scene));
  EXPECT_EQ(plan["steps"], stepCount(scene.scene));
  EXPECT_EQ(plan["tissue"]["agents"], std::llround(tissueCost(scene)->agents));
  EXPECT_EQ(plan["flow"]["kind"], "lattice nodes");
  EXPECT_EQ(plan["flow"]["likelySolves"][1], flowCost(scene)->manySolves);
  const std::string text = planText(scene);
  for (const auto& part : plan["parts"]) {
    EXPECT_NE(text.find(part["name"].get<std::string>()), std::string::npos) << part;
    EXPECT_NE(text.find(part["explanation"].get<std::string>()), std::string::npos) << part;
  }
}

/// The memory that the plan names [MB].
double memory(const Scene& scene) {
  const std::string text = planText(scene);
  const auto end = text.find(" MB, "), begin = text.rfind(' ', end - 1);
  return std::stod(text.substr(begin, end - begin));
}

TEST(Plan, EstimatesTheMemoryOfAgentsAndOfTheFieldAroundThem) {
  Scene scene;
  scene.mechanics.emplace();
  Scene fine = scene, finer = scene, longer = scene;
  fine.coupling.surfaceResolution = 5e-6;
  finer.coupling.surfaceResolution = 2.5e-6;
  longer.vessel.length *= 2;
  const double others = memory(scene);
  EXPECT_NEAR((memory(finer) - others) / (memory(fine) - others), 215.0 / 26, 0.05);
  // 670 bytes an agent and 7 a node of 15 um
  EXPECT_NEAR(memory(longer) - others, 248e3 * 670e-6 + 149 * 149 * 300 * 7e-6, 5);
}

}  // namespace
}  // namespace restenosis

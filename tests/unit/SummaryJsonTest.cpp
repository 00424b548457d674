#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "bridge/output/SummaryJson.h"
#include "bridge/output/Version.h"
#include "tests/support/TemporaryFolder.h"

namespace restenosis {
namespace {

Summary example() {
  Summary summary;
  summary.scene = "quick";
  summary.title = "Injury 2";
  summary.seed = 7;
  summary.threads = 2;
  summary.ranks = 3;
  summary.flowBackend = "foam";
  summary.stateDigest = "0123456789abcdef";
  summary.last.time = 864000;
  summary.last.agents = 70123;
  summary.last.neointimaThickness = 51e-6;
  summary.packing.emplace();
  summary.packing->counts.smc = 60000;
  summary.packing->ielDrift = -0.012e-6;
  summary.deployment.emplace();
  summary.deployment->freeInPath = 40;
  summary.deployment->escaped = 3;
  summary.deployment->escapedFree = 1;
  summary.deployment->laminaDistance = 95e-6;
  summary.deployment->largestStrain = 0.4;
  summary.flowSolvesDone = 5;
  summary.flowSolvesSkipped = {{"no covered cell", 72}, {"the lumen has moved too little", 8}};
  summary.flowMeshesMoved = 3;
  summary.flowRemeshed = {{"there was no former mesh", 1}, {"the wall moved too far", 1}};
  summary.parts["flow"] = {12.5, 300 << 20, 500 << 20, 5};
  summary.plan = {{"flow", true, "when the lumen has moved"}, {"nitric oxide", false, "no [endothelium]"}};
  summary.differences = {{"scene.seed", "7", "1", "seed"}, {"vessel.length", "2 mm", "", "length"}};
  summary.provenance = Provenance::ofThisProcess();
  return summary;
}

TEST(SummaryJson, SaysWhatTheContractAsks) {
  TemporaryFolder folder;
  writeSummaryJson(folder / "summary.json", example());
  const auto json = nlohmann::json::parse(readText(folder / "summary.json"));
  EXPECT_EQ(json["stateDigest"], "0123456789abcdef");
  EXPECT_EQ(json["version"], version());
  EXPECT_EQ(json["seed"], 7);
  EXPECT_EQ(json["threads"], 2);
  EXPECT_EQ(json["ranks"], 3);
  EXPECT_EQ(json["agents"], 70123);
  EXPECT_EQ(json["final"]["day"], 10.0);
  EXPECT_NEAR(json["final"]["neointimaThickness_um"].get<double>(), 51.0, 1e-9);
  EXPECT_TRUE(json["final"]["wssMean_Pa"].is_null());
  EXPECT_EQ(json["plan"][1]["runs"], false);
  EXPECT_EQ(json["plan"][1]["explanation"], "no [endothelium]");
  EXPECT_EQ(json["differsFromDefaults"][0]["default"], "1");
  EXPECT_TRUE(json["differsFromDefaults"][1]["default"].is_null());
  EXPECT_NE(json["provenance"]["command"].get<std::string>(), "");
  EXPECT_EQ(json["provenance"]["started"].get<std::string>().size(), 20u);
  EXPECT_EQ(json["packing"]["cells"], 60000);
  EXPECT_NEAR(json["packing"]["ielMeanRadialMoveOnRelease_um"].get<double>(), -0.012, 1e-9);
  EXPECT_EQ(json["packing"]["cellsOutsideLaminae"], 0);
  EXPECT_EQ(json["deployment"]["freeAgentsInTheWayOfStruts"], 40);
  EXPECT_EQ(json["deployment"]["agentsLumenwardOfStruts"], 3);
  EXPECT_EQ(json["deployment"]["freeAgentsLumenwardOfStruts"], 1);
  EXPECT_NEAR(json["deployment"]["ielToEelUnderStruts_um"].get<double>(), 95, 1e-9);
  EXPECT_EQ(json["deployment"]["largestBondStrain"], 0.4);
  EXPECT_TRUE(json["deployment"]["meanIelBondStrain"].is_null()) << "there were no such bonds";
  EXPECT_TRUE(json["injury"].is_null());
  EXPECT_EQ(json["flow"]["solvesDone"], 5);
  EXPECT_EQ(json["flow"]["solvesSkipped"], 80);
  EXPECT_EQ(json["flow"]["skippedBecause"]["no covered cell"], 72);
  EXPECT_EQ(json["flow"]["meshesMoved"], 3);
  EXPECT_EQ(json["flow"]["remeshedBecause"]["the wall moved too far"], 1);
  EXPECT_EQ(json["parts"]["flow"]["seconds"], 12.5);
  EXPECT_EQ(json["parts"]["flow"]["peakMemory_MiB"], 300.0);
  EXPECT_EQ(json["parts"]["flow"]["peakChildProcessMemory_MiB"], 500.0);
  EXPECT_EQ(json["totalSeconds"], 12.5);
}

TEST(SummaryJson, SurvivesATitleThatIsNotUtf8) {
  TemporaryFolder folder;
  auto summary = example();
  summary.title = "caf\xe9";
  writeSummaryJson(folder / "summary.json", summary);
  EXPECT_TRUE(nlohmann::json::accept(readText(folder / "summary.json")));
}

TEST(Version, IsNotEmpty) { EXPECT_FALSE(version().empty()); }

}  // namespace
}  // namespace restenosis

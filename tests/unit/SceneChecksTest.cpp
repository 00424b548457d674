#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

#include "bridge/scene/SceneChecks.h"
#include "bridge/scene/SceneReader.h"
#include "tests/support/TinyScene.h"

namespace restenosis {
namespace {

class SceneChecksTest : public ::testing::Test {
 protected:
  /// The one finding of a scene of these lines and the head, or all of them.
  std::string finding(const std::string& lines, const std::string& duration = "1 d") const {
    const std::string head = fmt::format("[scene]\nduration = \"{}\"\n", duration);
    try {
      SceneReader(units).readText(head + lines, "x.toml");
      return "accepted";
    } catch (const SceneError& error) {
      return error.what();
    }
  }
  static bool starts(const std::string& text, const std::string& with) { return text.rfind(with, 0) == 0; }
  const std::string vessel = "[vessel]\nlength = \"1.2 mm\"\nlumenDiameter = \"1.8 mm\"\n";  // lines 3 to 5
  Units units;
};

#define EXPECT_STARTS(text, with) EXPECT_TRUE(starts(text, with)) << (text)

TEST_F(SceneChecksTest, DurationIsAWholeNumberOfSteps) {
  EXPECT_STARTS(finding(vessel, "30 min"),
                "x.toml:2: 'duration' in [scene] is 0.5 h, shorter than one step of 1 h");
  EXPECT_STARTS(finding(vessel, "90 min"),
                "x.toml:2: 'duration' in [scene] is 1.5 h, not a whole number of steps of 1 h; the "
                "nearest allowed are 1 h and 2 h");
  EXPECT_STARTS(finding(vessel + "[scene.x]\n"), "x.toml:");
  EXPECT_STARTS(finding(vessel, "0.1 d"), "x.toml:2: 'duration' in [scene] is 2.4 h");
}

TEST_F(SceneChecksTest, SectionsNeedEachOther) {
  EXPECT_STARTS(finding(vessel + "[stent]\n"), "x.toml:6: [stent] needs [mechanics]");
  EXPECT_STARTS(finding(vessel + "[injury]\n"), "x.toml:6: [injury] needs [mechanics]");
  EXPECT_STARTS(finding(vessel + "[cellCycle]\n"), "x.toml:6: [cellCycle] needs [mechanics]");
  EXPECT_STARTS(finding(vessel + "[mechanics]\n[contactInhibition]\n"),
                "x.toml:7: [contactInhibition] needs [cellCycle]");
  EXPECT_STARTS(finding(vessel + "[mechanics]\n[endothelium]\n"),
                "x.toml:7: [endothelium] needs [cellCycle]");
  // A misspelt section is blamed once, not again by those that need it.
  const std::string misspelt = finding(vessel + "[mechnics]\n[stent]\n");
  EXPECT_STARTS(misspelt, "x.toml:6: unknown section [mechnics]");
  EXPECT_EQ(misspelt.find('\n'), std::string::npos) << misspelt;
}

TEST_F(SceneChecksTest, StenosisIsForVesselsWithoutTissue) {
  EXPECT_EQ(finding(vessel + "stenosis = 0.5\nstenosisLength = \"1 mm\"\n"), "accepted");
  EXPECT_STARTS(finding(vessel + "stenosis = 0.5\nstenosisLength = \"1 mm\"\n[mechanics]\n"),
                "x.toml:6: 'stenosis' shapes a vessel without tissue");
  EXPECT_STARTS(finding(vessel + "stenosis = 0.5\nstenosisLength = \"2 mm\"\n"),
                "x.toml:7: 'stenosisLength' in [vessel] is 2 mm, longer than the vessel (1.2 mm)");
}

TEST_F(SceneChecksTest, TheStentFitsTheVessel) {
  const std::string stent = vessel + "[mechanics]\n[stent]\n";  // lines 6 and 7
  EXPECT_EQ(finding(stent), "accepted");                        // one ring needs no length
  EXPECT_STARTS(finding(stent + "length = \"5 mm\"\n"),
                "x.toml:8: 'length' in [stent]: a stent of 5 mm is longer than the vessel (1.2 mm)");
  EXPECT_STARTS(finding(stent + "design = \"helix\"\n"),
                "x.toml:8: 'length' in [stent]: a stent of 3.5 mm is longer than the vessel");
  EXPECT_STARTS(finding(stent + "strutThickness = \"0.95 mm\"\n"),
                "x.toml:8: 'strutThickness' in [stent]: a strut 0.95 mm thick does not fit a lumen");
  EXPECT_STARTS(finding(stent + "deploymentDepth = \"250 um\"\n"),
                "x.toml:8: 'deploymentDepth' in [stent]: 250 um is beyond the wall: at most 170 um");
}

TEST_F(SceneChecksTest, AWrongKeySilencesOnlyWhatReadsIt) {
  const std::string narrow =  // lines 3 to 8
      "[vessel]\nlength = \"0.3 mm\"\nlumenDiameter = \"0.6 mm\"\nwallThickness = \"0.15 mm\"\n"
      "[mechanics]\n[stent]\n";
  const std::string slips = "strutThickness = \"0.7 mm\"\ndeploymentDepth = \"900 um\"\n";
  const std::string both =
      "x.toml:9: 'strutThickness' in [stent]: a strut 0.7 mm thick does not fit a lumen of radius 0.3 mm "
      "(half of vessel.lumenDiameter); allowed is less\n"
      "x.toml:10: 'deploymentDepth' in [stent]: 900 um is beyond the wall: at most 120 um leave the EEL "
      "(vessel.wallThickness less a cell's diameter)";
  EXPECT_EQ(finding(narrow + slips), both);
  EXPECT_STARTS(
      finding(narrow + slips + "length = \"3 mm\"\n"),
      both + "\nx.toml:11: 'length' in [stent]: a stent of 3 mm is longer than the vessel (0.3 mm)");
  for (const char* wrong : {"strutWidth = \"-1 mm\"\n", "ringCount = 0\n", "design = \"rnigs\"\n"})
    EXPECT_STARTS(finding(narrow + slips + wrong), both + "\nx.toml:11: ");
  const std::string noTable = with(narrow, "[mechanics]", "agents = \"nowhere.csv\"\n[mechanics]") + slips;
  for (const char* part :
       {":7: 'agents' in [vessel]", ":10: 'strutThickness' in", ":11: 'deploymentDepth' in"})
    EXPECT_NE(finding(noTable).find(part), std::string::npos) << finding(noTable);
  const std::string noStruts = finding(narrow + "file = \"nowhere.csv\"\ndeploymentDepth = \"900 um\"\n");
  for (const char* part : {":9: 'file' in [stent]", ":10: 'deploymentDepth' in"})
    EXPECT_NE(noStruts.find(part), std::string::npos) << noStruts;
  // The depth is not held against a thickness that is wrong itself
  const std::string thickness = finding(with(narrow, "0.15 mm", "-1 mm") +
                                        "deploymentDepth = \"900 um\"\nstrutThickness = \"0.7 mm\"\n");
  EXPECT_STARTS(thickness, "x.toml:6: ");
  EXPECT_NE(thickness.find("\nx.toml:10: 'strutThickness'"), std::string::npos) << thickness;
  EXPECT_EQ(thickness.find("deploymentDepth"), std::string::npos) << thickness;
  // What has no part in it does not silence the flow
  EXPECT_STARTS(finding(vessel + "radiusSpread = 7\n[flow]\nbackend = \"lbm\"\n[lbm]\ndx = \"300 um\"\n"),
                "x.toml:6: 'radiusSpread' in [vessel] is 7, out of bounds; allowed: at least 0, at most 0.3\n"
                "x.toml:10: 'dx' in [lbm] is 300 um");
}

TEST_F(SceneChecksTest, AFindingStandsWhereTheUserWroteItsCause) {
  EXPECT_STARTS(finding(with(vessel, "1.8 mm", "0.02 mm") + "[mechanics]\n"),
                "x.toml:5: 'surfaceResolution' in [coupling] is 15 um; a lumen of 0.02 mm");
  EXPECT_STARTS(finding(vessel + "wallThickness = \"0.1 mm\"\n[mechanics]\n[stent]\n"),
                "x.toml:6: 'deploymentDepth' in [stent]: 110 um is beyond the wall");
}

TEST_F(SceneChecksTest, AStentIsNoShorterThanItsRing) {
  EXPECT_STARTS(finding(vessel + "[mechanics]\n[stent]\nlength = \"0.05 mm\"\n"),
                "x.toml:8: 'length' in [stent]: a stent of 0.05 mm is shorter than its ring");
}

TEST_F(SceneChecksTest, TheWallHasRoomForItsLayers) {
  EXPECT_EQ(finding(vessel + "cellRadius = \"33 um\"\n[mechanics]\n"), "accepted");
  EXPECT_STARTS(finding(vessel + "cellRadius = \"34 um\"\n[mechanics]\n"),
                "x.toml:6: 'cellRadius' in [vessel] is 34 um; at most 33.3333 um");
  EXPECT_EQ(finding(vessel + "cellRadius = \"34 um\"\n"), "accepted");  // no tissue, no cells
  EXPECT_STARTS(finding(vessel + "cellRadius = \"1 um\"\n[mechanics]\n"),
                "x.toml:6: cells of radius 1 um make about 2.2e+08 agents");
  EXPECT_STARTS(finding(vessel + "fixedEnds = 50\n[mechanics]\n"),
                "x.toml:4: 'length' in [vessel]: 1.2 mm is no longer than the two fixed ends");
}

TEST_F(SceneChecksTest, CountsTheAgentsOfTheThesisVessel) {
  Scene scene;
  EXPECT_EQ(estimatedAgents(scene), 0);
  scene.mechanics.emplace();
  EXPECT_NEAR(estimatedAgents(scene), 248000, 2000);  // packed: 248,000 (model 2)
}

TEST_F(SceneChecksTest, TheFlowCanBeResolved) {
  const std::string lbm = vessel + "[flow]\nbackend = \"lbm\"\n[lbm]\n";  // lines 6 to 8
  EXPECT_EQ(finding(lbm), "accepted");
  EXPECT_STARTS(
      finding(lbm + "dx = \"2 um\"\n"),
      "x.toml:9: 'dx' in [lbm] is 2 um: a lumen of 1.8 mm and 1.2 mm length takes at least 4.9e+08 nodes, "
      "more than 'maximumNodes' = 1e+08");
  EXPECT_STARTS(
      finding(lbm + "dx = \"300 um\"\n"),
      "x.toml:9: 'dx' in [lbm] is 300 um: a lumen of 1.8 mm has 6 nodes across, at least 8 are needed");
  const std::string longer = vessel + "[flow]\nbackend = \"lbm\"\nstraightEnds = \"900 mm\"\n[lbm]\n";
  EXPECT_STARTS(finding(longer + "dx = \"25 um\"\n"),
                "x.toml:10: 'dx' in [lbm] is 25 um: a lumen of 1.8 mm and 1801 mm length, straight ends "
                "included, takes at least 3.7e+08 nodes");
  const std::string foam = vessel + "[flow]\n[foam]\n";  // lines 6 and 7
  EXPECT_EQ(finding(foam), "accepted");
  EXPECT_STARTS(finding(foam + "cellSize = \"5 um\"\n"),
                "x.toml:8: 'cellSize' in [foam] is 5 um: a lumen of");
  EXPECT_STARTS(finding(foam + "minimumCellsAcross = 50\n"), "x.toml:7: 'cellSize' in [foam] is 60 um");
  const std::string fine = foam + "cellSize = \"5 um\"\n[mechanics]\n";  // where the flow may never be due
  EXPECT_EQ(finding(fine), "accepted");
  EXPECT_STARTS(finding(fine + "[coupling]\nschedule = \"everyStep\"\n"), "x.toml:8: 'cellSize' in [foam]");
  EXPECT_EQ(finding(vessel + "[flow]\nbackend = \"none\"\n[foam]\ncellSize = \"5 um\"\n"), "accepted");
}

TEST_F(SceneChecksTest, ATubeOfExactlyTheLeastWidthWillDo) {
  const std::string foam = vessel + "[flow]\n[foam]\n";  // lines 6 and 7; the template's least is 8 cells
  EXPECT_EQ(finding(foam + "cellSize = \"225 um\"\n"), "accepted");
  EXPECT_STARTS(
      finding(foam + "cellSize = \"230 um\"\n"),
      "x.toml:8: 'cellSize' in [foam] is 230 um: a lumen of 1.8 mm has 7.8 cells across, at least 8");
  // A wall of agents may come out wider
  const std::string tissue = "[mechanics]\n[coupling]\nschedule = \"everyStep\"\n";
  EXPECT_EQ(finding(foam + "cellSize = \"230 um\"\n" + tissue), "accepted");
}

TEST_F(SceneChecksTest, TheVesselIsLongEnoughForItsFlow) {
  const std::string shorter = "[vessel]\nlength = \"0.01 mm\"\nlumenDiameter = \"1.8 mm\"\n[flow]\n";
  EXPECT_STARTS(finding(shorter),
                "x.toml:4: a lumen of 0.01 mm length has 0.17 cells along it, at least 0.5 are needed: "
                "'cellSize' in [foam] is 60 um");
  EXPECT_STARTS(finding(shorter + "backend = \"lbm\"\n"),
                "x.toml:4: a lumen of 0.01 mm length has 0.5 nodes along it, at least 3 are needed: 'dx' in "
                "[lbm] is 20 um");
  EXPECT_EQ(finding(shorter + "straightEnds = \"0.1 mm\"\n"), "accepted");
  EXPECT_EQ(finding(shorter + "backend = \"analytic\"\n"), "accepted");
}

TEST_F(SceneChecksTest, ValuesThatDefeatEachOther) {
  EXPECT_STARTS(finding(vessel + "[mechanics]\n[cellCycle]\ng1Spread = \"6 h\"\n"),
                "x.toml:8: 'g1Spread' in [cellCycle] is 6 h");
  // Slower flow than the residuals' norms can tell from none
  EXPECT_NE(finding(vessel + "[flow]\nmeanVelocity = \"1e-12 m/s\"\n").find("at least 1e-09 m/s"),
            std::string::npos);
  EXPECT_NE(finding(vessel + "[flow]\ndrive = \"pressureGradient\"\npressureGradient = \"1e-6 Pa/m\"\n")
                .find("at least 1e-09 m/s"),
            std::string::npos);
  EXPECT_STARTS(finding(vessel + "[flow]\ndrive = \"pressureGradient\"\npressureGradient = \"0 Pa/m\"\n"),
                "x.toml:8: 'pressureGradient' in [flow] is 0");
  const std::string distal = vessel + "[flow]\ndrive = \"resistance\"\n";
  EXPECT_EQ(finding(distal), "accepted");
  EXPECT_STARTS(finding(distal + "distalResistance = \"1e-3 mmHg min/ml\"\n"),
                "x.toml:8: 'distalResistance' in [flow] lets");
  const std::string casson = vessel + "[flow]\nviscosity = \"casson\"\n";
  EXPECT_EQ(finding(casson), "accepted");
  EXPECT_STARTS(finding(casson + "backend = \"analytic\"\n"),
                "x.toml:7: 'viscosity' in [flow] is \"casson\"");
  EXPECT_NE(finding(casson + "zeroShearViscosity = \"1e-4 Pa s\"\n").find("it does not thicken"),
            std::string::npos);
  const std::string beating = vessel + "[flow]\nwaveform = \"coronaryLeft\"\n";
  EXPECT_EQ(finding(beating), "accepted");
  EXPECT_STARTS(finding(beating + "backend = \"lbm\"\n"),
                "x.toml:7: 'waveform' in [flow] makes the flow beat");
  EXPECT_STARTS(finding(beating + "drive = \"pressureGradient\"\n"),
                "x.toml:7: 'waveform' in [flow] says how the flow rate beats");
  EXPECT_EQ(finding(beating + "drive = \"resistance\"\n"), "accepted");
  EXPECT_STARTS(finding(beating + "crossCheck = \"lbm\"\n"),
                "x.toml:7: 'waveform' in [flow] makes the flow beat, and");
  const std::string cycle = vessel + "[mechanics]\n[cellCycle]\n[endothelium]\n";  // lines 6 to 8
  EXPECT_EQ(finding(cycle), "accepted");
  EXPECT_STARTS(finding(cycle + "nitricOxideTransition = \"0.1 Pa\"\n"),
                "x.toml:9: nitric oxide would fall with wall shear stress above 'nitricOxideTransition'");
  const std::string coarse = "[coupling]\nsurfaceResolution = \"200 um\"\n";
  EXPECT_STARTS(finding(vessel + "[mechanics]\n" + coarse),
                "x.toml:8: 'surfaceResolution' in [coupling] is 200 um");
  EXPECT_EQ(finding(vessel + coarse), "accepted");  // a tube has its own triangles
}

}  // namespace
}  // namespace restenosis

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "bridge/scene/SceneReader.h"
#include "tests/support/TinyScene.h"

namespace restenosis {
namespace {

/// Nine lines; what a test appends starts on line 10.
const std::string start = R"([scene]
duration = "10 d"
step = "1 h"
[vessel]
length = "1.2 mm"
lumenDiameter = "1.8 mm"
[mechanics]
[cellCycle]

)";

class SceneReaderTest : public ::testing::Test {
 protected:
  std::vector<Diagnostic> findings(const std::string& toml,
                                   const std::vector<SceneOverride>& overrides = {}) const {
    try {
      SceneReader(units).readText(toml, "scenes/x.toml", overrides);
    } catch (const SceneError& error) {
      return error.diagnostics();
    }
    return {};
  }
  /// Expects exactly one finding, on this line, whose message contains every part.
  void expectOne(const std::string& toml, int line, const std::vector<std::string>& parts,
                 const std::vector<SceneOverride>& overrides = {}) const {
    const auto found = findings(toml, overrides);
    ASSERT_EQ(found.size(), 1u) << toml << (found.empty() ? "" : SceneError(found).what());
    EXPECT_EQ(found[0].line, line) << toString(found[0]);
    for (const auto& part : parts) {
      EXPECT_NE(toString(found[0]).find(part), std::string::npos) << toString(found[0]) << "\nlacks " << part;
    }
  }
  Units units;
};

TEST_F(SceneReaderTest, ReadsValuesAndKeepsDefaults) {
  const Scene scene =
      SceneReader(units).readText(start + "[flow]\nmeanVelocity = \"20 cm/s\"\n", "scenes/x.toml");
  EXPECT_EQ(scene.name, "x");
  EXPECT_EQ(scene.scene.duration, 864000.0);
  EXPECT_EQ(scene.vessel.length, 1.2e-3);
  EXPECT_EQ(scene.vessel.wallThickness, VesselParameters().wallThickness);
  ASSERT_TRUE(scene.flow.has_value());
  EXPECT_EQ(scene.flow->meanVelocity, 0.2);
  EXPECT_EQ(scene.flow->density, FlowParameters().density);
  EXPECT_FALSE(scene.stent.has_value());
  EXPECT_FALSE(scene.endothelium.has_value());
}

TEST_F(SceneReaderTest, LeavesToTheFidelityWhatIsNotGiven) {
  const auto read = [&](std::string_view fidelity, const std::string& more) {
    return SceneReader(units).readText(start + more, "scenes/x.toml",
                                       {{fmt::format("scene.fidelity={}", fidelity)}});
  };
  for (const char* fidelity : {"draft", "standard", "reference"}) {
    SCOPED_TRACE(fidelity);
    const auto coupling = CouplingParameters::forFidelity(fidelity);
    EXPECT_EQ(read(fidelity, "").coupling.lumenTolerance, coupling.lumenTolerance);
    const Scene given = read(fidelity,
                             "[flow]\n[foam]\nwallLevel = 3\n[lbm]\nwarmStart = false\n"
                             "[coupling]\nlumenTolerance = \"7 um\"\n");
    EXPECT_EQ(given.coupling.lumenTolerance, 7e-6);
    EXPECT_EQ(given.coupling.lumenInterval, coupling.lumenInterval);
    EXPECT_EQ(given.foam->wallLevel, 3);
    EXPECT_EQ(given.foam->cellSize, FoamSettings::forFidelity(fidelity).cellSize);
    EXPECT_EQ(given.foam->tolerance, FoamSettings::forFidelity(fidelity).tolerance);
    EXPECT_EQ(given.lbm->dx, LbmSettings::forFidelity(fidelity).dx);
  }
  EXPECT_GT(read("draft", "").coupling.lumenTolerance, read("standard", "").coupling.lumenTolerance);
  EXPECT_EQ(read("standard", "").coupling.lumenTolerance, CouplingParameters().lumenTolerance);
}

TEST_F(SceneReaderTest, NamesUnknownKeysAndTheNearest) {
  const auto found =
      findings("[scene]\nduration = \"1 d\"\n[vessel]\nlenght = \"1 mm\"\nlumenDiameter = \"1.8 mm\"\n");
  ASSERT_EQ(found.size(), 1u);  // not a second time as missing
  EXPECT_EQ(toString(found[0]).rfind(
                "scenes/x.toml:4: unknown key 'lenght' in [vessel]; did you mean 'length'? "
                "Allowed: lumenSurface, lumenSurfaceUnit, centreline, centrelineUnit, length, lumenDiameter",
                0),
            0u)
      << toString(found[0]);
  EXPECT_EQ(found[0].column, 1);
  expectOne(start + "[flow]\nqwertyuiop = 1\n", 11, {"unknown key 'qwertyuiop' in [flow]. Allowed: backend"});
  expectOne(start + "[flow]\nlumenTolerance = \"5 um\"\n", 11, {"it belongs in [coupling]"});
}

TEST_F(SceneReaderTest, NamesUnknownSections) {
  expectOne("[scene]\nduration = \"1 d\"\n[vesel]\nlength = \"1 mm\"\n", 3,
            {"unknown section [vesel]; did you mean 'vessel'?", "Allowed: scene, vessel, stent"});
  expectOne(start + "[endotelium]\nscenario = \"fast\"\n", 10, {"did you mean 'endothelium'?"});
  expectOne("seed = 1\n" + start, 1, {"'seed' stands outside of any section"});
  expectOne(start + "[[stent]]\nlength = \"1 mm\"\n", 10, {"is a list; write [stent]"});
}

TEST_F(SceneReaderTest, NamesWhatIsMissing) {
  expectOne("[scene]\nduration = \"1 d\"\n", 1, {"section [vessel] is missing"});
  expectOne("[scene]\nstep = \"1 h\"\n[vessel]\nlength = \"1 mm\"\nlumenDiameter = \"1.8 mm\"\n", 1,
            {"key 'duration' is missing in [scene]; expected: a time, larger than 0 d, at most 10000 d, for "
             "example duration = \""});
  expectOne(
      "[scene]\nduration = \"1 d\"\n[vessel]\nlength = \"1 mm\"\n", 3,
      {"key 'lumenDiameter' is missing in [vessel]; expected: a length, larger than 0 mm, at most 50 mm, "
       "for example lumenDiameter = \"1.8 mm\""});
  const auto both = findings("");
  ASSERT_EQ(both.size(), 2u);
}

TEST_F(SceneReaderTest, ExplainsWrongTypes) {
  expectOne(start + "[stent]\nlength = 1\n", 11,
            {"is the number 1 without a unit", "a length with its unit", "length = \"1 mm\""});
  expectOne(start + "[stent]\nlength = true\n", 11, {"is true without a unit", "length = \"3.5 mm\""});
  expectOne(start + "[injury]\nsyntheticReach = \"2\"\n", 11, {"a plain number", "syntheticReach = 1.5"});
  expectOne(start + "[injury]\nielBreaks = \"true\"\n", 11, {"expected true or false, without quotes"});
  expectOne(start + "[stent]\nlength = \"1 mm\"\ndeploymentSteps = 1.5\n", 12,
            {"is the number 1.5; a whole number is expected"});
  expectOne(start + "[stent]\ndeploymentSteps = 8.0\n", 11,
            {"is 8.0, a number with a decimal point or an exponent; a whole number is expected, for example "
             "deploymentSteps = 8"});
  expectOne(start + "[flow]\nbackend = 3\n", 11, {"text in quotes"});
  expectOne(start + "[flow]\nbackend = [\"foam\"]\n", 11, {"is a list"});
  expectOne(start + "[flow]\nmeanVelocity = 2026-01-01\n", 11, {"is a date or time"});
}

TEST_F(SceneReaderTest, ExplainsWrongUnits) {
  expectOne(start + "[flow]\nmeanVelocity = \"1 mm\"\n", 11,
            {"'meanVelocity' in [flow]", "expected a velocity"});
  expectOne(start + "[flow]\nmeanVelocity = \"1\"\n", 11, {"has no unit", "m/s"});
  expectOne(start + "[flow]\nmeanVelocity = \"1 smoots\"\n", 11,
            {"'smoots' is not a unit", "expected a velocity"});
  expectOne(start + "[flow]\nmeanVelocity = \"nan m/s\"\n", 11, {"not a finite number"});
  expectOne(start + "[flow]\nmeanVelocity = \"\"\n", 11, {"is empty"});
}

TEST_F(SceneReaderTest, HoldsValuesToTheirBounds) {
  expectOne(start + "[flow]\nmeanVelocity = \"-1 cm/s\"\n", 11,
            {"-0.01 m/s, out of bounds; allowed: at least 1e-09 m/s, at most 10 m/s"});
  expectOne(start + "[injury]\nfenestrationProbability = 1.5\n", 11, {"at least 0, at most 1"});
  expectOne(start + "[injury]\nfenestrationProbability = nan\n", 11, {"not a finite number"});
  expectOne(start + "[injury]\nfenestrationProbability = inf\n", 11, {"not a finite number"});
  expectOne(start + "[stent]\nlength = \"1 mm\"\ndeploymentSteps = 0\n", 12, {"at least 1"});
  EXPECT_TRUE(findings(start + "[injury]\nfenestrationProbability = 1\n").empty());
  EXPECT_TRUE(findings(start + "[stent]\nstrutWidth = \"10 um\"\n").empty());  // the bound, in another unit
  expectOne("[scene]\nduration = \"0 d\"\n[vessel]\nlength = \"1 mm\"\nlumenDiameter = \"1.8 mm\"\n", 2,
            {"'duration' in [scene] is 0 d", "larger than 0 d"});
  expectOne("[scene]\nduration = \"1 d\"\n[vessel]\nlength = \"-1 mm\"\nlumenDiameter = \"1.8 mm\"\n", 4,
            {"-1 mm, out of bounds"});
}

TEST_F(SceneReaderTest, OffersTheChoices) {
  expectOne(start + "[flow]\nbackend = \"faom\"\n", 11,
            {"cannot be \"faom\"; did you mean 'foam'? Allowed: foam"});
  expectOne(start + "[coupling]\nremesh = \"never\"\n", 11,
            {"cannot be \"never\"", "Allowed: always, onDemand"});
  EXPECT_TRUE(findings(start + "[coupling]\nremesh = \"onDemand\"\n").empty());
}

TEST_F(SceneReaderTest, PlacesBrokenToml) {
  expectOne("[scene]\nduration = \"1 d\n", 2, {"not valid TOML", "closing quote"});
  expectOne("[scene]\nduration = 1 d\n", 2, {"not valid TOML", "stands in quotes"});
  expectOne("[scene\n", 1, {"not valid TOML"});
  expectOne(start + "[flow]\nbackend = \"foam\"\nbackend = \"none\"\n", 12, {"not valid TOML", "backend"});
  expectOne(start + "[scene]\n", 10, {"not valid TOML", "scene"});
  expectOne(start + "[stent]\ndeploymentSteps = 99999999999999999999\n", 11, {"not valid TOML", "64 bits"});
}

TEST_F(SceneReaderTest, ReportsEverythingAtOnce) {
  const auto found = findings(start +
                                  "[stent]\nlength = 1\nstrutWidth = \"5 s\"\nshape = \"round\"\n"
                                  "[flow]\nmeanVelocity = \"99 m/s\"\n[floww]\n",
                              {"flow.density=1 mm"});
  ASSERT_EQ(found.size(), 6u) << SceneError(found).what();
  for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(found[k].line, static_cast<int>(11 + k));
  EXPECT_EQ(found[3].line, 15);
  EXPECT_EQ(found[4].line, 16);
  EXPECT_EQ(found[5].file, "--set flow.density");
}

TEST_F(SceneReaderTest, RefusesFilesThatAreNone) {
  const std::filesystem::path folder = std::filesystem::path(::testing::TempDir()) / "SceneReaderTest";
  std::filesystem::create_directories(folder / "folder.csv");
  std::ofstream(folder / "there.csv") << "x,y,z,radius\n0,855,600,15\n";
  std::ofstream(folder / "quick.toml") << start + "[stent]\nfile = \"there.csv\"\n";
  const SceneReader reader(units);
  const Scene scene = reader.readFile(folder / "quick.toml");
  EXPECT_EQ(scene.name, "quick");
  EXPECT_EQ(scene.stent->file, (folder / "there.csv").lexically_normal().string());

  const auto errorOf = [&reader](const std::filesystem::path& file,
                                 const std::vector<SceneOverride>& overrides = {}) {
    try {
      reader.readFile(file, overrides);
      return std::string("accepted");
    } catch (const SceneError& error) {
      return std::string(error.what());
    }
  };
  EXPECT_NE(errorOf(folder / "quik.toml").find("no such scene file; did you mean"), std::string::npos);
  EXPECT_NE(errorOf(folder).find("is a folder"), std::string::npos);
  EXPECT_NE(errorOf(folder / "quick.toml", {"stent.file=absent.csv"}).find("does not exist"),
            std::string::npos);
  EXPECT_NE(errorOf(folder / "quick.toml", {"stent.file=folder.csv"}).find("is a folder"), std::string::npos);
  std::ofstream(folder / "quick.toml") << start + "[stent]\nfile = \"nowhere.csv\"\n";
  EXPECT_NE(errorOf(folder / "quick.toml").find("quick.toml:11: 'file' in [stent]"), std::string::npos);
  std::filesystem::remove_all(folder);
}

TEST_F(SceneReaderTest, AppliesOverrides) {
  const Scene scene = SceneReader(units).readText(
      start, "scenes/x.toml",
      {"vessel.length=2 mm", "vessel.length = \"3 mm\"", "scene.seed=7", "scene.title=2026",
       "flow.backend=analytic", "endothelium=present", "endothelium.scenario=3-23 days", "cellCycle=present",
       "output.pictures=false"});
  EXPECT_EQ(scene.vessel.length, 3e-3);
  EXPECT_EQ(scene.scene.seed, 7);
  EXPECT_EQ(scene.scene.title, "2026");
  EXPECT_EQ(scene.flow.value().backend, "analytic");
  EXPECT_TRUE(scene.endothelium.has_value());
  EXPECT_FALSE(scene.output.pictures);
  EXPECT_FALSE(SceneReader(units).readText(start, "x.toml", {"cellCycle=absent"}).cellCycle.has_value());
}

TEST_F(SceneReaderTest, BlamesOverridesByName) {
  expectOne(start, 0, {"--set vessel.lenght: unknown key 'lenght'", "did you mean 'length'"},
            {"vessel.lenght=1 mm"});
  expectOne(start, 0, {"--set flo.backend: unknown section [flo]; did you mean 'flow'"},
            {"flo.backend=foam"});
  expectOne(start, 0, {"--set vessel.length: 'length' in [vessel] is the number 3"}, {"vessel.length=3"});
  expectOne(start, 0, {"--set scene.seed", "whole number"}, {"scene.seed=1\n[flow]"});
  expectOne(start, 0, {"--set vessel.length: no value"}, {"vessel.length"});
  expectOne(start, 0, {"--set flow: write flow.key=value"}, {"flow=analytic"});
  expectOne(start, 0, {"--set scene.title: is not text in UTF-8"}, {"scene.title=a\xff"});
  expectOne(start, 0, {"--set scene.title: is not text in UTF-8 without control characters"},
            {"scene.title=a\x01z"});
  expectOne(start, 0, {"--set seed: no section; write section.key=value; did you mean scene.seed?"},
            {"seed=2"});
  expectOne(start, 0, {"did you mean scene.seed?"}, {"sead=2"});
  expectOne(start, 0, {"did you mean vessel.length or stent.length?"}, {"length=2 mm"});
  expectOne(start, 0, {"--set nothingLikeIt: write nothingLikeIt.key=value"}, {"nothingLikeIt=2"});
  expectOne(start, 0, {"no section"}, {"=3"});
  expectOne(start, 0, {"no key"}, {"vessel.=3"});
  expectOne(start, 1, {"section [vessel] is missing"}, {"vessel=absent"});
  expectOne(start, 0, {"--set contactInhibiton: unknown section [contactInhibiton]; did you mean"},
            {"contactInhibiton=absent"});
}

TEST_F(SceneReaderTest, BlamesTheOptionThatWasTyped) {
  expectOne(start, 0, {"--flow: 'backend' in [flow] cannot be \"foo\"", "Allowed: foam"},
            {{"flow.backend=foo", "--flow"}});
}

TEST_F(SceneReaderTest, NumericalSettingsAreFollowedToTheirSection) {
  const std::string former = with(start, "[mechanics]", "[mechanics]\ntolerance = 0.08\nbondAxialFactor = 2");
  const Scene scene = SceneReader(units).readText(former, "x.toml");
  EXPECT_EQ(scene.relaxation->tolerance, 0.002);
  EXPECT_EQ(scene.mechanics->bondAxialFactor, 2);
  ASSERT_EQ(scene.remarks.size(), 1u);
  EXPECT_EQ(
      scene.remarks[0],
      "of [mechanics] these keys belong in [relaxation], where they are taken to be: tolerance; tolerance, a "
      "force over C r0^2 there, as 0.002 of a radius");

  EXPECT_EQ(SceneReader(units).readText(start, "x.toml").relaxation->tolerance,
            RelaxationParameters().tolerance);
  expectOne(former + "[relaxation]\ntolerance = 0.02\n", 8, {"tolerance", "it belongs in [relaxation]"});
  expectOne(with(start, "[mechanics]\n[cellCycle]", "[relaxation]"), 7, {"[relaxation] needs [mechanics]"});
  expectOne(with(start, "[mechanics]", "[mechanics]\ntolerance = -1"), 8, {"'tolerance' in [relaxation]"});
}

}  // namespace
}  // namespace restenosis

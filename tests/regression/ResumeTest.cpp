#include <random>
#include <thread>

#include "bridge/coupling/Run.h"
#include "bridge/output/Checkpoint.h"
#include "bridge/output/ResultsFolder.h"
#include "bridge/scene/SceneFingerprint.h"
#include "bridge/scene/SceneReader.h"
#include "bridge/scene/Units.h"
#include "bridge/surface/StlFile.h"
#include "tests/support/StrutSolids.h"
#include "tests/support/WholeProgram.h"

namespace restenosis {
namespace {

using namespace std::chrono_literals;

class Resume : public WholeProgram {
 protected:
  void sleepUntilAge(Process& process, double seconds) const {
    while (process.running() && process.age() < seconds) std::this_thread::sleep_for(2ms);
  }
  template <class Condition>
  void sleepUntil(Process& process, Condition condition) const {
    while (process.running() && !condition()) std::this_thread::sleep_for(2ms);
  }
  std::size_t recorded(const std::string& results) const {
    const std::string series = readText(folder.path() / results / "timeSeries.csv");
    return static_cast<std::size_t>(std::ranges::count(series, '\n'));
  }
  void expectSameResults(const std::string& results, const std::string& reference) const {
    EXPECT_EQ(digest(results), digest(reference));
    for (const char* file : {"timeSeries.csv", "profile.csv", "tissue.pvd", "lumen.pvd", "scene.toml"})
      EXPECT_TRUE(readText(folder.path() / results / file) == readText(folder.path() / reference / file))
          << file << " differs";
  }
};

TEST_F(Resume, AfterTenKillsAtAnyMomentTheResultsAreThoseOfTheUninterruptedRun) {
  const std::string tiny = scene("tiny", tinyScene);
  const ProcessEnd reference = run({"run", tiny, "-o", "reference"});
  ASSERT_EXIT_STATUS(reference, 0);
  std::mt19937 random(20240229);
  std::uniform_real_distribution<double> within(0, 1);
  int killed = 0;
  for (int n = 0; n < 10; ++n) {
    SCOPED_TRACE(n);
    const std::string out = "out" + std::to_string(n);
    Process process(command({"run", tiny, "-o", out}), folder.path());
    if (n == 0) {
      // The state before deployment has just been saved, so this falls into deployment on any machine.
      sleepUntil(process, [&] { return exists(out + "/checkpoint/state.bin"); });
    } else {
      sleepUntilAge(process, reference.seconds * (n - 1 + within(random)) / 9);
    }
    process.send(SIGKILL);
    const ProcessEnd end = process.wait(patience);
    if (end.signal == SIGKILL) ++killed;
    // A run that has not yet made its folder has nothing to go on from.
    const bool begun = exists(out + "/.restenosisFoam");
    std::vector<std::string> again = {"run", tiny, "-o", out};
    if (begun) again.push_back("--resume");
    ASSERT_EXIT_STATUS(run(again), 0);
    expectSameResults(out, "reference");
  }
  EXPECT_GE(killed, 6) << "the machine was much faster than when the reference ran";
}

TEST_F(Resume, CtrlCSavesTheStateAndSaysHowToGoOn) {
  const std::string tiny = scene("tiny", with(tinyScene, "deploymentSteps = 8", "deploymentSteps = 24"));
  ASSERT_EXIT_STATUS(run({"run", tiny, "-o", "reference"}), 0);
  Process deploying(command({"run", tiny, "-o", "out"}), folder.path());
  sleepUntil(deploying, [&] { return exists("out/checkpoint/state.bin"); });
  deploying.send(SIGINT);
  ProcessEnd end = deploying.wait(patience);
  EXPECT_EXIT_STATUS(end, 1);
  EXPECT_NE(end.err.find(" of 24 of deployment: go on with `"), std::string::npos) << end.err;
  EXPECT_FALSE(exists("out/timeSeries.csv")) << "this was to fall into deployment";

  Process growing(command({"run", tiny, "-o", "out", "--resume"}), folder.path());
  sleepUntil(growing, [&] { return recorded("out") >= 4; });
  growing.send(SIGINT);
  end = growing.wait(patience);
  EXPECT_EXIT_STATUS(end, 1);
  EXPECT_NE(end.err.find("--resume"), std::string::npos) << end.err;

  ASSERT_EXIT_STATUS(run({"run", tiny, "-o", "out", "--resume"}), 0);
  expectSameResults("out", "reference");
}

TEST_F(Resume, AfterAnInterruptionInTheLastStepOfDeploymentTheResultsAreTheSame) {
  const std::string tiny = scene("tiny", with(with(tinyScene, "deploymentSteps = 8", "deploymentSteps = 1"),
                                              "deploymentDepth = \"40 um\"", "deploymentDepth = \"10 um\""));
  ASSERT_EXIT_STATUS(run({"run", tiny, "-o", "reference"}), 0);
  {
    const Scene read = SceneReader(Units()).readFile(folder / tiny, {});
    const ResultsFolder results = ResultsFolder::fresh(folder / "out");
    std::ostringstream nowhere;
    Progress progress(nowhere, false, read.scene.duration);
    const std::atomic<bool> stop{true};
    EXPECT_THROW(restenosis::Run(read, results, progress, {.stopRequested = &stop}).go(), Interrupted);
  }
  EXPECT_FALSE(exists("out/timeSeries.csv")) << "deployment asks first";
  EXPECT_EQ(summary("out")["status"], "interrupted");
  ASSERT_EXIT_STATUS(run({"run", tiny, "-o", "out", "--resume"}), 0);
  expectSameResults("out", "reference");
}

/// Every day the agents are put in another order; what was summed in the first one has to be kept.
TEST_F(Resume, DoesNotDependOnTheOrderOfTheAgents) {
  const std::string ordered = scene("ordered", R"([scene]
duration = "74 h"
step = "1 h"
[vessel]
length = "0.4 mm"
lumenDiameter = "0.57 mm"
wallThickness = "0.14 mm"
cellRadius = "23 um"
[stent]
strutWidth = "0.045 mm"
strutThickness = "0.035 mm"
deploymentDepth = "90 um"
deploymentSteps = 7
[injury]
[mechanics]
[cellCycle]
[output]
pictures = false
)");
  ASSERT_EXIT_STATUS(run({"run", ordered, "-o", "reference"}), 0);
  ASSERT_EXIT_STATUS(run({"run", ordered, "-o", "out", "--set", "scene.duration=3 d"}), 0);
  ASSERT_EXIT_STATUS(run({"run", ordered, "-o", "out", "--resume"}), 0);
  EXPECT_EQ(digest("out"), digest("reference"));
}

TEST_F(Resume, GoesOnWithAFinishedRunForLonger) {
  const std::string tiny = scene("tiny", tinyScene);
  ASSERT_EXIT_STATUS(run({"run", tiny, "-o", "reference"}), 0);
  ASSERT_EXIT_STATUS(run({"run", tiny, "-o", "out", "--set", "scene.duration=3 d"}), 0);
  ASSERT_EXIT_STATUS(run({"run", tiny, "-o", "out", "--resume"}), 0);
  expectSameResults("out", "reference");
}

TEST_F(Resume, RefusesACheckpointThatIsDamagedOrOfAnotherScene) {
  const std::string tiny = scene("tiny", with(tinyScene, "\"4 d\"", "\"6 h\""));
  ASSERT_EXIT_STATUS(run({"run", tiny, "-o", "out"}), 0);
  const auto file = folder / "out/checkpoint/state.bin";
  const std::string intact = readText(file);
  const auto expectRefused = [&](const std::vector<std::string>& options, const std::string& why) {
    const auto before = contents("out");
    std::vector<std::string> arguments = {"run", tiny, "-o", "out", "--resume"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const ProcessEnd end = run(arguments);
    EXPECT_EXIT_STATUS(end, 2);
    EXPECT_NE(end.err.find(why), std::string::npos) << end.err;
    EXPECT_NE(end.err.find("out/checkpoint/state.bin"), std::string::npos) << end.err;
    EXPECT_EQ(std::ranges::count(end.err, '\n'), 2) << end.err;  // the first: how narrow this lumen is
    EXPECT_TRUE(contents("out") == before) << "something has changed in the results";
  };
  for (const std::size_t place : {intact.size() / 2, intact.size() - 1, std::size_t{30}}) {
    SCOPED_TRACE(place);
    std::string flipped = intact;
    flipped[place] = static_cast<char>(flipped[place] ^ 1);
    writeText(file, flipped);
    expectRefused({}, "damaged");
  }
  for (const std::size_t size : {intact.size() - 1, intact.size() / 2, std::size_t{12}}) {
    SCOPED_TRACE(size);
    writeText(file, intact.substr(0, size));
    expectRefused({}, "cut off");
  }
  writeText(file, "something else altogether, but long enough for a header\n");
  expectRefused({}, "not a checkpoint");
  writeText(file, intact);
  expectRefused({"--set", "scene.seed=2"}, "they differ in scene.seed");
  expectRefused({"--set", "vessel.length=0.3 mm"}, "another scene");
  expectRefused({"--set", "scene.duration=2 h"}, "past scene.duration = 0.08333 d");
  ASSERT_EXIT_STATUS(run({"run", tiny, "-o", "out", "--resume"}), 0);
}

TEST_F(Resume, NamesAnInputFileThatHasBeenExchanged) {
  const std::string tiny = scene(
      "tiny", with(with(with(tinyScene, "design = \"ring\"", "file = \"ring.stl\""), "\"4 d\"", "\"2 h\""),
                   "deploymentSteps = 8", "deploymentSteps = 1"));
  const auto writeRing = [&](double width) {
    writeStl(folder / "ring.stl", support::squareRing(0.2e-3, width, 0.24e-3), 1e-3);
  };
  writeRing(60e-6);
  ASSERT_EXIT_STATUS(run({"run", tiny, "-o", "out", "--flow", "none"}), 0);
  writeRing(50e-6);
  const auto before = contents("out");
  const ProcessEnd end = run({"run", tiny, "-o", "out", "--flow", "none", "--resume"});
  EXPECT_EXIT_STATUS(end, 2);
  EXPECT_TRUE(end.err.ends_with("ring.stl (stent.file) has been changed since the run was started\n"))
      << end.err;
  EXPECT_EXIT_STATUS(run({"run", tiny, "-o", "out", "--flow", "none", "--resume", "--set", "scene.seed=2"}),
                     2);
  EXPECT_TRUE(contents("out") == before) << "something has changed in the results";
  std::filesystem::rename(folder / "ring.stl", folder / "elsewhere.stl");
  const ProcessEnd lost = run({"run", tiny, "-o", "out", "--flow", "none", "--resume"});
  EXPECT_EXIT_STATUS(lost, 2);
  EXPECT_NE(lost.err.find("ring.stl does not exist"), std::string::npos) << lost.err;
  writeRing(60e-6);
  EXPECT_EXIT_STATUS(run({"run", tiny, "-o", "out", "--flow", "none", "--resume"}), 0);
}

/// Version, compiler and processor are part of what a state depends on.
TEST_F(Resume, OfAStateThatAnotherProgramHasSavedSaysSo) {
  const std::string tiny = scene("tiny", tinyScene);
  ASSERT_EXIT_STATUS(run({"run", tiny, "-o", "out", "--set", "scene.duration=2 d"}), 0);
  ASSERT_EXIT_STATUS(run({"run", tiny, "-o", "out", "--set", "scene.duration=3 d", "--resume"}), 0);
  EXPECT_NE(summary("out")["sceneFingerprint"], "");
  EXPECT_TRUE(summary("out")["remarks"].empty());

  const std::string fingerprint = checkpointFingerprint(SceneReader(Units()).readFile(folder / tiny, {}));
  StoredState stored = Checkpoint(folder / "out/checkpoint").loadWithOrigin(fingerprint);
  for (const char* trait : {"version", "compiler", "instructions", "processor"})
    EXPECT_EQ(stored.origin.traits.count(trait), 1U) << trait;
  stored.origin.traits["compiler"] = "of old";
  Checkpoint(folder / "out/checkpoint", stored.origin).save(fingerprint, stored.bytes);
  const ProcessEnd end = run({"run", tiny, "-o", "out", "--set", "scene.duration=3.5 d", "--resume"});
  EXPECT_EXIT_STATUS(end, 0);
  EXPECT_NE(end.err.find("(before: of old)"), std::string::npos) << end.err;
  EXPECT_EXIT_STATUS(run({"run", tiny, "-o", "out", "--resume"}), 0);
  EXPECT_EQ(summary("out")["sceneFingerprint"], "");
  ASSERT_EQ(summary("out")["remarks"].size(), 1U) << summary("out")["remarks"];
  const std::string remark = summary("out")["remarks"][0];
  EXPECT_TRUE(remark.starts_with("resumed on day 3 by another program or machine")) << remark;
}

TEST_F(Resume, ReplacesLinksAmongItsResultsAndDoesNotFollowThem) {
  const std::string tiny = scene("tiny", with(tinyScene, "\"4 d\"", "\"2 h\""));
  ASSERT_EXIT_STATUS(run({"run", tiny, "-o", "out"}), 0);
  const std::string files[] = {"summary.json", "timeSeries.csv", "scene.toml", "checkpoint/state.bin",
                               "tissue/tissue_000000.vtp"};
  std::filesystem::create_directory(folder / "important");
  for (std::size_t n = 0; n < std::size(files); ++n) {
    const auto target = folder / ("important/" + std::to_string(n));
    std::filesystem::rename(folder / ("out/" + files[n]), target);
    std::filesystem::create_symlink(target, folder / ("out/" + files[n]));
  }
  const auto before = contents("important");
  EXPECT_EXIT_STATUS(run({"run", tiny, "-o", "out", "--resume", "--set", "scene.title=Other"}), 0);
  EXPECT_TRUE(contents("important") == before);
  std::filesystem::create_directory_symlink(folder / "important", folder / "out/flow");
  const ProcessEnd end = run({"run", tiny, "-o", "out", "--resume"});
  EXPECT_EXIT_STATUS(end, 2);
  EXPECT_NE(end.err.find("out/flow is a link"), std::string::npos) << end.err;
  EXPECT_EXIT_STATUS(run({"run", tiny, "-o", "out"}), 0);
  EXPECT_TRUE(contents("important") == before);
}

/// Nodes near enough that the flow is solved without remarks.
const std::string inFineLattice = with(tinyScene, "\"analytic\"", "\"lbm\"") + "[lbm]\ndx = \"25 um\"\n";

TEST_F(Resume, AFlowThatFailsForItsSettingsIsSolvedWithOthers) {
  const std::string tiny = scene("tiny", inFineLattice);
  const std::vector<std::string> resume = {"run", tiny, "-o", "out", "--resume"};
  const auto withSettings = [](std::vector<std::string> arguments, const std::string& more) {
    arguments.insert(arguments.end(), {"--set", more});
    return arguments;
  };
  ASSERT_EXIT_STATUS(run({"run", tiny, "-o", "reference"}), 0);
  ASSERT_GE(summary("reference")["flow"]["solvesDone"], 2);
  EXPECT_TRUE(summary("reference")["remarks"].empty());

  const ProcessEnd failed = run(withSettings({"run", tiny, "-o", "out"}, "lbm.maximumSteps=100"));
  EXPECT_EXIT_STATUS(failed, 1);
  EXPECT_NE(failed.err.find("settings in [foam] or [lbm]"), std::string::npos) << failed.err;
  EXPECT_EXIT_STATUS(run(withSettings(resume, "lbm.maximumSteps=100")), 1);
  // The settings that nothing was solved with are not missed
  ASSERT_EXIT_STATUS(run(resume), 0);
  EXPECT_EQ(digest("out"), digest("reference"));
  EXPECT_TRUE(summary("out")["remarks"].empty());
}

TEST_F(Resume, WithOtherSettingsOfTheFlowSolvesItAnewAndSaysSo) {
  const std::string tiny = scene("tiny", inFineLattice);
  const auto resumed = [&](const std::string& results, const std::string& dx, const std::string& duration) {
    return run({"run", tiny, "-o", results, "--resume", "--set", "lbm.dx=" + dx, "--set",
                "scene.duration=" + duration});
  };
  ASSERT_EXIT_STATUS(run({"run", tiny, "-o", "out", "--set", "scene.duration=3.5 d"}), 0);
  ASSERT_GE(summary("out")["flow"]["solvesDone"], 1);
  std::filesystem::copy(folder / "out", folder / "straight", std::filesystem::copy_options::recursive);

  const ProcessEnd end = resumed("straight", "22 um", "4 d");
  ASSERT_EXIT_STATUS(end, 0);
  const std::string change = "lbm.dx = 22 um (before: 25 um)";
  EXPECT_NE(end.err.find("the flow goes on with other settings than before: " + change), std::string::npos)
      << end.err;
  const auto after = summary("straight");
  ASSERT_EQ(after["remarks"].size(), 1U) << after["remarks"];
  EXPECT_EQ(after["remarks"][0], "flow at day 3.500: solved with other settings than before: " + change);
  EXPECT_EQ(after["sceneFingerprint"], "");

  // Stopped and resumed on the way, it ends in the same state
  ASSERT_EXIT_STATUS(resumed("out", "22 um", "3.75 d"), 0);
  const ProcessEnd again = resumed("out", "22 um", "4 d");
  ASSERT_EXIT_STATUS(again, 0);
  EXPECT_EQ(again.err.find("other settings"), std::string::npos) << again.err;
  EXPECT_EQ(digest("out"), digest("straight"));
  EXPECT_EQ(summary("out")["flow"], after["flow"]);
  EXPECT_EQ(summary("out")["sceneFingerprint"], "");
}

TEST_F(Resume, AFlowInALumenThatStaysIsSolvedAnewWithOtherSettings) {
  const std::string tube = scene("tube",
                                 "[scene]\ntitle = \"tube\"\nduration = \"1 h\"\nstep = \"1 h\"\n"
                                 "[vessel]\nlength = \"1 mm\"\nlumenDiameter = \"0.5 mm\"\n"
                                 "[flow]\nbackend = \"lbm\"\n[lbm]\ndx = \"50 um\"\n"
                                 "[output]\npictures = false\n");
  ASSERT_EXIT_STATUS(run({"run", tube, "-o", "out"}), 0);
  const auto coarse = summary("out");
  ASSERT_EXIT_STATUS(run({"run", tube, "-o", "out", "--resume"}), 0);
  EXPECT_EQ(summary("out")["flow"]["solvesDone"], coarse["flow"]["solvesDone"]);
  ASSERT_EXIT_STATUS(run({"run", tube, "-o", "out", "--resume", "--set", "lbm.dx=25 um"}), 0);
  const auto fine = summary("out");
  EXPECT_EQ(fine["flow"]["solvesDone"], 1 + int{coarse["flow"]["solvesDone"]});
  EXPECT_LT(std::abs(double{fine["poiseuille"]["l2Error"]}),
            std::abs(double{coarse["poiseuille"]["l2Error"]}));
}

TEST_F(Resume, GoesOnWithTheBondsThatBrokeAndWereMade) {
  const std::string tiny = scene(
      "tiny", with(tinyScene, "[mechanics]", "[mechanics]\nbondDaughters = true\nbondStrainLimit = 0.3"));
  ASSERT_EXIT_STATUS(run({"run", tiny, "-o", "whole"}), 0);
  ASSERT_EXIT_STATUS(run({"run", tiny, "-o", "parts", "--set", "scene.duration=3 d"}), 0);
  ASSERT_EXIT_STATUS(run({"run", tiny, "-o", "parts", "--resume", "--threads", "1"}), 0);
  EXPECT_EQ(summary("parts")["stateDigest"], summary("whole")["stateDigest"]);
  ASSERT_EXIT_STATUS(run({"run", scene("plain", tinyScene), "-o", "plain"}), 0);
  EXPECT_NE(summary("plain")["stateDigest"], summary("whole")["stateDigest"]);
}

TEST_F(Resume, GoesOnWithActivationMatrixAndTheMaturityOfEndothelium) {
  const std::string growing = scene("growing", growingScene());
  ASSERT_EXIT_STATUS(run({"run", growing, "-o", "whole"}), 0);
  ASSERT_EXIT_STATUS(run({"run", growing, "-o", "parts", "--set", "scene.duration=2 d"}), 0);
  ASSERT_EXIT_STATUS(run({"run", growing, "-o", "parts", "--resume", "--threads", "1"}), 0);
  expectSameResults("parts", "whole");
}

/// The strain of the tissue is measured from where agents were packed, which a checkpoint must keep.
TEST_F(Resume, OfADeploymentKnowsWhereAgentsWerePacked) {
  const std::string growing =
      scene("growing", with(with(growingScene(), "duration = \"4 d\"", "duration = \"2 h\""),
                            "deploymentSteps = 8", "deploymentSteps = 24"));
  ASSERT_EXIT_STATUS(run({"run", growing, "-o", "reference"}), 0);
  Process deploying(command({"run", growing, "-o", "out"}), folder.path());
  sleepUntil(deploying, [&] { return exists("out/checkpoint/state.bin"); });
  deploying.send(SIGINT);
  EXPECT_EXIT_STATUS(deploying.wait(patience), 1);
  EXPECT_FALSE(exists("out/timeSeries.csv")) << "this was to fall into deployment";
  ASSERT_EXIT_STATUS(run({"run", growing, "-o", "out", "--resume"}), 0);
  EXPECT_EQ(digest("out"), digest("reference"));
  EXPECT_EQ(summary("out")["injury"], summary("reference")["injury"]);
}

TEST_F(Resume, BeginsWhereARunWasKilledBeforeItMadeItsFolder) {
  const std::string tiny = scene("tiny", tinyScene);
  ASSERT_EXIT_STATUS(run({"run", tiny, "-o", "whole"}), 0);
  std::filesystem::create_directory(folder.path() / "empty");
  for (const auto* out : {"nowhere", "empty"}) {
    const ProcessEnd end = run({"run", tiny, "-o", out, "--resume"});
    ASSERT_EXIT_STATUS(end, 0);
    EXPECT_NE((end.out + end.err).find("no checkpoint: starting afresh"), std::string::npos) << end.out;
    EXPECT_EQ(summary(out)["stateDigest"], summary("whole")["stateDigest"]);
  }
}

TEST_F(Resume, RefusesAFolderOfSomethingElse) {
  std::filesystem::create_directory(folder.path() / "mine");
  std::ofstream(folder.path() / "mine" / "thesis.txt") << "mine";
  const ProcessEnd end = run({"run", scene("tiny", tinyScene), "-o", "mine", "--resume"});
  EXPECT_EXIT_STATUS(end, 2);
  EXPECT_NE(end.err.find("is not a results folder of restenosisFoam"), std::string::npos) << end.err;
}

}  // namespace
}  // namespace restenosis

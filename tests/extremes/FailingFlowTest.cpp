#include <regex>
#include <thread>

#include "tests/support/OpenFoamPresent.h"
#include "tests/support/WholeProgram.h"

namespace restenosis {
namespace {

namespace fs = std::filesystem;

class FailingFlow : public WholeProgram {
 protected:
  std::string foamScene() const { return scene("tiny", tinyFoamScene()); }
  /// A folder for the PATH whose blockMesh is this shell script.
  std::string pathWithBlockMesh(const std::string& script) const {
    const auto bin = folder / "bin";
    fs::create_directory(bin);
    writeText(bin / "blockMesh", "#!/bin/sh\n" + script + "\n");
    fs::permissions(bin / "blockMesh", fs::perms::owner_all);
    return bin.string() + ":/usr/bin:/bin";
  }
  /// The results up to the failure are whole: six rows, one each half day, and a summary that says so.
  void expectResultsKept() const {
    const CsvColumns series(folder / "out/timeSeries.csv");
    EXPECT_EQ(series.rows(), 6u);  // the endothelium, and so the flow, comes at day 3
    EXPECT_EQ(summary("out")["status"], "failed");
    EXPECT_EQ(summary("out")["flow"]["solvesDone"], 0);
    EXPECT_TRUE(exists("out/checkpoint/state.bin"));
  }
};

TEST_F(FailingFlow, WithoutOpenFoamTheProgramAndItsPackageAreNamed) {
  const std::string tiny = foamScene();
  const ProcessEnd end = run({"run", tiny, "-o", "out"}, {{"PATH", "/nonexistent"}});
  EXPECT_EXIT_STATUS(end, 1);
  for (const char* part : {"'blockMesh'", "apt install openfoam", "--resume"})
    EXPECT_NE(end.err.find(part), std::string::npos) << end.err;
  EXPECT_EQ(end.err.find("Read ."), std::string::npos) << "there is no log to read:\n" << end.err;
  expectResultsKept();

  // It goes on from where it was: the same failure again, and nothing is lost or repeated.
  const std::string before = readText(folder / "out/timeSeries.csv");
  const ProcessEnd again = run({"run", tiny, "-o", "out", "--resume"}, {{"PATH", "/nonexistent"}});
  EXPECT_EXIT_STATUS(again, 1);
  EXPECT_EQ(readText(folder / "out/timeSeries.csv"), before);
  EXPECT_EQ(again.err.find("packing"), std::string::npos) << "it has started from the beginning:\n"
                                                          << again.err;
}

TEST_F(FailingFlow, AFailingProgramIsNamedWithItsLog) {
  const auto path = pathWithBlockMesh("echo '--> FOAM FATAL ERROR: '; echo 'the moon is full'; exit 1");
  const ProcessEnd end = run({"run", foamScene(), "-o", "out"}, {{"PATH", path}});
  EXPECT_EXIT_STATUS(end, 1);
  for (const char* part : {"blockMesh", "the moon is full", "--resume"})
    EXPECT_NE(end.err.find(part), std::string::npos) << end.err;
  std::smatch log;
  ASSERT_TRUE(std::regex_search(end.err, log, std::regex("Read (\\S+)\\. "))) << end.err;
  EXPECT_NE(readText(folder / log[1].str()).find("the moon is full"), std::string::npos);
  expectResultsKept();
}

TEST_F(FailingFlow, ASolutionFarFromPoiseuillesLawIsNone) {
  RESTENOSIS_NEEDS_OPENFOAM();
  const fs::path thick = folder / "thick";
  fs::copy(fs::path(RESTENOSIS_SOURCE_DIR) / "foamCase", thick, fs::copy_options::recursive);
  const fs::path blood = thick / "constant/transportProperties";
  writeText(blood, with(readText(blood), "$kinematicViscosity", "5.4e-6"));  // twice that of the scene
  const std::string tube = scene("tube", R"([scene]
duration = "1 h"
fidelity = "draft"
[vessel]
length = "0.4 mm"
lumenDiameter = "1.2 mm"
[flow]
drive = "flowRate"
)");
  const ProcessEnd end = run({"run", tube, "-o", "out"}, {{"RESTENOSIS_FOAM_CASE", thick}});
  EXPECT_EXIT_STATUS(end, 1);
  for (const char* part : {"off Poiseuille's law, 2.39 Pa, by +100 %", "out/flow/0"})
    EXPECT_NE(end.err.find(part), std::string::npos) << end.err;
}

/// OpenFOAM's programs may end with status 0 and no result.
TEST_F(FailingFlow, AProgramThatDoesNothingIsFound) {
  const ProcessEnd end = run({"run", foamScene(), "-o", "out"}, {{"PATH", pathWithBlockMesh("exit 0")}});
  EXPECT_EXIT_STATUS(end, 1);
  EXPECT_NE(end.err.find("The flow failed: "), std::string::npos) << end.err;
  expectResultsKept();
}

/// One that waits for what never comes.
TEST_F(FailingFlow, AProgramThatHangsIsNamedWithItsLogAndEnded) {
  const ProcessEnd end = run({"run", foamScene(), "-o", "out", "--set", "foam.silenceLimit=0.001 min"},
                             {{"PATH", pathWithBlockMesh("exec sleep 100000")}});
  EXPECT_EXIT_STATUS(end, 1);
  for (const char* part : {"blockMesh hangs: its log has not grown for 0.001 min (foam.silenceLimit)",
                           "log.blockMesh", "go on with --resume"})
    EXPECT_NE(end.err.find(part), std::string::npos) << end.err;
  expectResultsKept();
}

/// And goes on from the day of that solve, with what was printed.
TEST_F(FailingFlow, AProgramThatHangsCanBeInterrupted) {
  // Nothing else than the solve is a reason to save on that day
  const std::string text = scene("tiny", with(tinyFoamScene(), "\"6 h\"", "\"100 d\""));
  const std::string duration = "scene.duration=74 h";
  Process process(command({"run", text, "-o", "out", "--set", duration}), folder.path(),
                  {{"PATH", pathWithBlockMesh("echo here; exec sleep 100000")}});
  const auto hangs = [&] {
    if (!exists("out/flow")) return false;
    for (const auto& entry : fs::directory_iterator(folder / "out/flow"))
      if (readText(entry.path() / "log.blockMesh") == "here\n") return true;
    return false;
  };
  while (process.running() && !hangs()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  process.send(SIGINT);
  const ProcessEnd end = process.wait(patience);
  EXPECT_EXIT_STATUS(end, 1);
  std::smatch said;
  const std::regex words("\ninterrupted, saved at day 3.00: go on with `(.*)`\n");
  ASSERT_TRUE(std::regex_search(end.err, said, words)) << end.err;
  EXPECT_EQ(summary("out")["status"], "interrupted");

  RESTENOSIS_NEEDS_OPENFOAM();
  const ProcessEnd resumed = Process({"/bin/sh", "-c", said[1].str()}, folder.path()).wait(patience);
  ASSERT_EXIT_STATUS(resumed, 0);
  EXPECT_NE(resumed.err.find("resuming from day 3.00\n"), std::string::npos) << resumed.err;
  ASSERT_EXIT_STATUS(run({"run", text, "-o", "reference", "--set", duration}), 0);
  EXPECT_EQ(digest("out"), digest("reference"));
  for (const char* counted : {"solvesDone", "solvesSkipped"})
    EXPECT_EQ(summary("out")["flow"][counted], summary("reference")["flow"][counted]) << counted;
}

}  // namespace
}  // namespace restenosis

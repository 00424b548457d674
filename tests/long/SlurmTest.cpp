#include <gtest/gtest.h>

#include <memory>
#include <sstream>

#include "tests/support/EnvironmentVariable.h"
#include "tests/support/OpenFoamPresent.h"
#include "tests/support/WholeProgram.h"

namespace restenosis {
namespace {

namespace fs = std::filesystem;

/// A real Slurm of two nodes on this machine.
class Slurm : public WholeProgram {
 protected:
  void SetUp() override {
    if (std::system("command -v slurmctld slurmd munged >/dev/null") != 0)
      GTEST_SKIP() << "slurm-wlm is not installed";
    const ProcessEnd started = script("start");
    ASSERT_EXIT_STATUS(started, 0);
    conf_ = std::make_unique<EnvironmentVariable>("SLURM_CONF",
                                                  started.out.substr(0, started.out.find('\n')).c_str());
  }
  void TearDown() override {
    if (conf_) script("stop");
  }
  ProcessEnd script(const std::string& verb) const {
    return Process({RESTENOSIS_SOURCE_DIR "/tests/long/slurmOnOneMachine", verb, (folder / "slurm").string()},
                   folder.path())
        .wait(patience);
  }
  /// A program of Slurm, or another one.
  ProcessEnd slurm(std::vector<std::string> words) const {
    words.insert(words.begin(), "/usr/bin/env");  // which seeks it on the PATH
    return Process(words, folder.path()).wait(patience);
  }
  /// State of a job, as in "RUNNING", and how often it was queued up again.
  std::pair<std::string, int> job(const std::string& id) const {
    const std::string shown = slurm({"scontrol", "show", "job", id}).out;
    const auto value = [&](const std::string& key) {
      const auto at = shown.find(key);
      return at == std::string::npos
                 ? std::string()
                 : shown.substr(at + key.size(), shown.find_first_of(" \n", at) - at - key.size());
    };
    return {value("JobState="), value("Restarts=").empty() ? 0 : std::stoi(value("Restarts="))};
  }
  template <class Condition>
  bool comesTrue(const Condition& condition) const {
    for (int n = 0; n < 3000; ++n) {
      if (condition()) return true;
      usleep(100'000);
    }
    return false;
  }

 private:
  std::unique_ptr<EnvironmentVariable> conf_;
};

TEST_F(Slurm, AFlowOnTwoNodesIsThatOfTwoProcesses) {
  RESTENOSIS_NEEDS_OPENFOAM();
  const std::string foam = scene("foam", tinyFoamScene());
  const std::vector<std::string> options = {"run", foam, "--ranks", "2", "--set", "scene.duration=3.5 d"};
  auto here = options, there = options;
  here.insert(here.end(), {"-o", "here"});
  there.insert(there.end(), {"-o", "there", "--launcher", "srun --mpi=pmix"});
  ASSERT_EXIT_STATUS(run(here), 0);
  std::string words;
  for (const std::string& word : command(there)) words += "'" + word + "' ";
  writeText(folder / "job", "#!/bin/bash\n#SBATCH --nodes=2 --ntasks-per-node=1\n" + words + "\n");
  const ProcessEnd end = slurm({"sbatch", "--wait", "-o", "job.log", "job"});
  ASSERT_EQ(end.status, 0) << toString(end) << readText(folder / "job.log");
  EXPECT_EQ(digest("there"), digest("here"));
  EXPECT_GT(summary("there")["flow"]["solvesDone"], 0);
}

TEST_F(Slurm, AnArrayOfSeedsGoesOnAfterARequestToStop) {
  const std::string tiny = scene("tiny", with(tinyScene, "step = \"2 h\"", "step = \"10 min\""));
  fs::create_directories(folder / "build/release");
  fs::create_symlink(RESTENOSIS_PROGRAM, folder / "build/release/restenosisFoam");
  const ProcessEnd submitted = slurm({"sbatch", "--parsable", "--array=1-2", "--mem=500M",
                                      RESTENOSIS_SOURCE_DIR "/studies/slurm/seeds.sbatch", tiny});
  ASSERT_EXIT_STATUS(submitted, 0);
  const std::string first = submitted.out.substr(0, submitted.out.find('\n')) + "_1";
  ASSERT_TRUE(comesTrue([&] { return exists("results/seeds/tiny-1/timeSeries.csv"); }));
  ASSERT_EXIT_STATUS(slurm({"scancel", "--batch", "--signal=INT", first}), 0);
  const auto done = [&](const std::string& seed) {
    const std::string file = "results/seeds/tiny-" + seed + "/summary.json";
    return exists(file) && readText(folder / file).find("\"finished\"") != std::string::npos;
  };
  ASSERT_TRUE(comesTrue([&] { return done("1") && done("2"); })) << slurm({"scontrol", "show", "job"}).out;
  EXPECT_EQ(job(first).second, 1) << "it was not queued up again";
  for (const char* seed : {"1", "2"}) {
    ASSERT_EXIT_STATUS(run({"run", tiny, "-o", "reference", "--set", std::string("scene.seed=") + seed}), 0);
    EXPECT_EQ(digest(std::string("results/seeds/tiny-") + seed), digest("reference"));
    fs::remove_all(folder / "reference");
  }
}

TEST_F(Slurm, SnakemakeMakesAStudyOfJobs) {
  if (std::system("command -v snakemake >/dev/null") != 0) GTEST_SKIP() << "snakemake is not installed";
  scene("tiny", tinyScene);
  writeText(folder / "study.toml",
            "scenes = [\"tiny.toml\"]\nseeds = [1, 2]\ncolumns = [\"smc\"]\ndays = [4]\nmemory_MiB = 500\n");
  const ProcessEnd end =
      slurm({RESTENOSIS_SOURCE_DIR "/studies/start", "study.toml", "-o", "out", "--program",
             RESTENOSIS_PROGRAM, "--profile", RESTENOSIS_SOURCE_DIR "/studies/slurm"});
  ASSERT_EXIT_STATUS(end, 0);
  EXPECT_TRUE(exists("out/study.html"));
  ASSERT_EXIT_STATUS(run({"run", "tiny.toml", "-o", "reference", "--set", "scene.seed=2"}), 0);
  EXPECT_EQ(readText(folder / "out/runs/tiny_seed2.finished"), digest("reference") + "\n");
}

}  // namespace
}  // namespace restenosis

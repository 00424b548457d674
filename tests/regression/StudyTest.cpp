#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/WholeProgram.h"

namespace restenosis {
namespace {

namespace fs = std::filesystem;

/// Studies of small runs, and the scripts that start and collect them.
class Studies : public WholeProgram {
 protected:
  Studies() { scene("tiny", tinyScene); }
  ProcessEnd start(const std::string& study) const {
    writeText(folder / "study.toml", study);
    return Process({RESTENOSIS_SOURCE_DIR "/studies/start", "study.toml", "-o", "out", "--program",
                    RESTENOSIS_PROGRAM},
                   folder.path())
        .wait(patience);
  }
  ProcessEnd script(const std::string& name) const {
    return Process({"/usr/bin/python3", RESTENOSIS_SOURCE_DIR "/studies/workflow/" + name, "../study.toml"},
                   folder / "out")
        .wait(patience);
  }
  static constexpr std::string_view study = R"(title = "Two lengths of G1"
scenes = ["tiny.toml"]
seeds = [1, 2]
columns = ["smc"]
days = [0, 0.25, 4, 9]
[settings]
"scene.duration" = "1 d"
[grid]
"cellCycle.g1Mean" = ["12 h", "16 h"]
)";
};

TEST_F(Studies, WhatIsWrongIsNamedAndNothingIsWritten) {
  const auto expectRefused = [&](const std::string& wrong, const std::string& says) {
    const ProcessEnd end = start(wrong);
    EXPECT_EQ(end.status, 2) << toString(end);
    EXPECT_NE(end.err.find(says), std::string::npos) << "expected: " << says << '\n' << toString(end);
    EXPECT_FALSE(exists("out"));
  };
  expectRefused(with(study, "seeds", "seedz"), "no such key: 'seedz'");
  expectRefused(with(study, "[1, 2]", "[]"), "'seeds' is empty");
  expectRefused(with(study, "[1, 2]", "[1.5]"), "'seeds' must be whole numbers");
  expectRefused(with(study, "[1, 2]", "[1, 1]"), "two runs are called tiny_cellCycle.g1Mean=12_h_seed1");
  expectRefused(with(study, "tiny.toml", "other.toml"), "no such scene");
  expectRefused(with(study, "[\"12 h\", \"16 h\"]", "\"12 h\""), "must be a list of values");
  expectRefused(with(study, "scene.duration", "scene.seed"), "not by 'scene.seed'");
  expectRefused(with(study, "scene.duration", "cellCycle.g1Mean"), "in [settings] and in [grid]");
  expectRefused(with(study, "g1Mean", "g1Meen"), "did you mean 'g1Mean'?");
  expectRefused(with(study, "16 h", "16 kg"), "g1Mean=16_kg_seed1");
  expectRefused("scenes = [", "study.toml");
}

TEST_F(Studies, TablesHoldTheRunsByGroupAndDay) {
  writeText(folder / "study.toml", std::string(study));
  fs::create_directories(folder / "out/runs");
  const auto made = [&](const std::string& name, const std::string& status, double final) {
    const fs::path run = folder / "out/runs" / name;
    fs::create_directories(run);
    writeText(run / "summary.json", R"({"status": ")" + status + R"("})");
    writeText(run / "timeSeries.csv", "day,smc\n0,100\n0.5,\n1," + std::to_string(final) + "\n");
  };
  made("tiny_cellCycle.g1Mean=12_h_seed1", "finished", 300);
  made("tiny_cellCycle.g1Mean=12_h_seed2", "occluded", 500);
  made("tiny_cellCycle.g1Mean=16_h_seed1", "finished", 200);
  made("tiny_cellCycle.g1Mean=16_h_seed2", "interrupted", 200);
  ProcessEnd end = script("collect.py");
  EXPECT_EQ(end.status, 1) << toString(end);
  EXPECT_NE(end.err.find("seed2: the run has not ended: interrupted"), std::string::npos) << end.err;
  made("tiny_cellCycle.g1Mean=16_h_seed2", "finished", 200);
  end = script("collect.py");
  ASSERT_EQ(end.status, 0) << toString(end);
  EXPECT_EQ(readText(folder / "out/table.csv"),
            "scene,cellCycle.g1Mean,day,column,mean,least,most,runs\n"
            "tiny,12 h,0,smc,100,100,100,2\n"
            "tiny,12 h,0.25,smc,175,150,200,2\n"
            "tiny,12 h,4,smc,400,300,500,2\n"
            "tiny,12 h,9,smc,400,300,500,2\n"
            "tiny,16 h,0,smc,100,100,100,2\n"
            "tiny,16 h,0.25,smc,125,125,125,2\n"
            "tiny,16 h,4,smc,200,200,200,2\n"
            "tiny,16 h,9,smc,200,200,200,2\n");
  EXPECT_NE(readText(folder / "out/curves.csv").find("tiny,12 h,1,0.5,\n"), std::string::npos);
}

TEST_F(Studies, ATableOfPointsIsOneGroup) {
  const std::string points = with(with(study, "seeds = [1, 2]", "points = \"points.csv\"\nfirst = 2"),
                                  "[grid]\n\"cellCycle.g1Mean\" = [\"12 h\", \"16 h\"]\n", "");
  writeText(folder / "study.toml", points);
  writeText(folder / "points.csv", "cellCycle.g1Mean,scene.seed\n12 h,7\n16 h,8\n20 h,9\n");
  for (const int n : {1, 2}) {
    const fs::path run = folder / fmt::format("out/runs/tiny_point000{}", n);
    fs::create_directories(run);
    writeText(run / "summary.json", R"({"status": "finished"})");
    writeText(run / "timeSeries.csv", fmt::format("day,smc\n0,100\n1,{}00\n", n));
  }
  const ProcessEnd end = script("collect.py");
  ASSERT_EQ(end.status, 0) << toString(end);
  EXPECT_EQ(readText(folder / "out/curves.csv"),
            "scene,point,seed,day,smc\ntiny,1,7,0.0,100.0\ntiny,1,7,1.0,100.0\ntiny,2,8,0.0,100.0\n"
            "tiny,2,8,1.0,200.0\n");
  EXPECT_NE(readText(folder / "out/table.csv").find("tiny,4,smc,150,100,200,2\n"), std::string::npos);
  // Of two scenes each has every point
  scene("other", tinyScene);
  writeText(folder / "study.toml", with(points, "\"tiny.toml\"", "\"tiny.toml\", \"other.toml\""));
  for (const int n : {1, 2})
    fs::copy(folder / "out/runs/tiny_point0001", folder / fmt::format("out/runs/other_point000{}", n));
  const ProcessEnd both = script("collect.py");
  ASSERT_EQ(both.status, 0) << toString(both);
  EXPECT_NE(readText(folder / "out/curves.csv").find("other,2,8,1.0,100.0\n"), std::string::npos);
  EXPECT_EQ(start(with(points, "[settings]", "[grid]\n\"cellCycle.g1Mean\" = [\"12 h\"]\n[settings]")).status,
            2);
}

TEST_F(Studies, WhatIsKeptNeedsNoFolder) {
  writeText(folder / "study.toml", with(study, "days", "kept = \"kept\"\ndays"));
  for (const char* name : {"12_h_seed1", "12_h_seed2", "16_h_seed1", "16_h_seed2"}) {
    const fs::path run = folder / (std::string("out/runs/tiny_cellCycle.g1Mean=") + name);
    fs::create_directories(run);
    writeText(run / "summary.json", R"({"status": "finished", "version": "1", "stateDigest": "abc",
      "totalSeconds": 3.21, "parts": {"relax": {"seconds": 2.5, "peakMemory_MiB": 7.4}}})");
    writeText(run / "timeSeries.csv", "day,smc,divisions\n0,100,0\n0.5,,1\n1,200,2\n");
  }
  ProcessEnd end = script("collect.py");
  ASSERT_EQ(end.status, 0) << toString(end);
  const std::string table = readText(folder / "out/table.csv");
  const std::string runs = readText(folder / "kept/runs.csv");
  EXPECT_EQ(runs.find("run,status,version,digest,seconds,peak_MiB,peakChildProcess_MiB,relax_s\n"
                      "tiny_cellCycle.g1Mean=12_h_seed1,finished,1,abc,3.2,7,0,2.5\n"),
            0U)
      << runs;
  fs::remove_all(folder / "out/runs");
  const std::string kept = readText(folder / "kept/curves.csv");
  EXPECT_NE(kept.find("tiny_cellCycle.g1Mean=16_h_seed1,0.5,\n"), std::string::npos) << kept;
  end = script("collect.py");
  ASSERT_EQ(end.status, 0) << toString(end);
  EXPECT_EQ(readText(folder / "out/table.csv"), table);
  EXPECT_EQ(readText(folder / "kept/curves.csv"), kept);
  ASSERT_EXIT_STATUS(script("draw.py"), 0);
  const ProcessEnd page = script("page.py");
  ASSERT_EXIT_STATUS(page, 0);
  EXPECT_NE(
      page.out.find("<td>tiny_cellCycle.g1Mean=16_h_seed2</td><td>finished</td><td>1</td><td>0.00</td>"),
      std::string::npos)
      << page.out;
  writeText(folder / "kept/curves.csv", "run,day,smc\n");
  end = script("collect.py");
  EXPECT_EQ(end.status, 1);
  EXPECT_NE(end.err.find("curves.csv: no run tiny_cellCycle.g1Mean=12_h_seed1"), std::string::npos)
      << end.err;
}

TEST_F(Studies, ARunThatIsMissingIsNamed) {
  writeText(folder / "study.toml", std::string(study));
  fs::create_directories(folder / "out");
  const ProcessEnd end = script("collect.py");
  EXPECT_EQ(end.status, 1);
  EXPECT_NE(end.err.find("tiny_cellCycle.g1Mean=12_h_seed1"), std::string::npos) << end.err;
}

}  // namespace
}  // namespace restenosis

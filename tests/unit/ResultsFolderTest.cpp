#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <functional>
#include <optional>
#include <set>

#include "bridge/output/ResultsFolder.h"
#include "bridge/system/AtomicFile.h"
#include "tests/support/TemporaryFolder.h"

namespace restenosis {
namespace {

namespace fs = std::filesystem;

std::string refusal(const std::function<void()>& use) {
  try {
    use();
  } catch (const FolderRefused& error) {
    return error.what();
  }
  return "";
}

TEST(ResultsFolder, IsCreatedWithThoseAboveIt) {
  TemporaryFolder folder;
  const auto results = ResultsFolder::fresh(folder / "results/quick");
  EXPECT_TRUE(fs::is_directory(folder / "results/quick"));
  EXPECT_EQ(results.flowCase(3.125 * 86400).filename(), "3.125");
  EXPECT_EQ(results.flowCase(20 * 86400).filename(), "20");
  EXPECT_EQ(results.flowCase(0).filename(), "0");
  EXPECT_NE(results.flowCase(1000 * 86400), results.flowCase(1000 * 86400 + 60));
}

TEST(ResultsFolder, RemovesTheCasesOfLaterSolves) {
  TemporaryFolder folder;
  const auto results = ResultsFolder::fresh(folder / "results");
  results.removeFlowCasesAfter(0);
  const double last = 3.125 * 86400 + 0.1;  // not a number of days with five decimals
  const std::vector<double> times{0, 3 * 86400, last, last + 60, 20 * 86400};
  for (const double time : times) fs::create_directories(results.flowCase(time) / "system");
  fs::create_directory(folder / "results/flow/9 my own");
  fs::create_directory(folder / "results/flow/21.partial");
  const auto left = [&] { return std::distance(fs::directory_iterator(folder / "results/flow"), {}); };
  results.removeFlowCasesAfter(last);
  EXPECT_EQ(left(), 4) << "three cases and the user's folder";
  for (const double time : times) EXPECT_EQ(fs::exists(results.flowCase(time)), time <= last) << time;
  results.removeFlowCasesBut(std::array{results.flowCase(0), results.flowCase(last), fs::path()});
  EXPECT_EQ(left(), 3);
  for (const double time : times)
    EXPECT_EQ(fs::exists(results.flowCase(time)), time == 0 || time == last) << time;
  results.removeFlowCasesAfter(std::nullopt);
  EXPECT_EQ(left(), 1);
  EXPECT_TRUE(fs::exists(folder / "results/flow/9 my own"));
}

/// Remarks name the logs of attempts that failed.
TEST(ResultsFolder, KeepsTheLogsOfFailedAttemptsOfCasesThatItRemoves) {
  TemporaryFolder folder;
  const auto results = ResultsFolder::fresh(folder / "results");
  const fs::path tried = results.flowCase(86400), sound = results.flowCase(2 * 86400);
  for (const fs::path& flow : {tried, sound})
    for (const char* inner : {"system", "constant/polyMesh", "0", "12"}) fs::create_directories(flow / inner);
  for (const char* log : {"firstAttempt/log.snappyHexMesh", "movedMesh/log.checkMesh", "log.simpleFoam"}) {
    fs::create_directories((tried / log).parent_path());
    writeText(tried / log, log);
  }
  results.removeFlowCasesBut(std::array{results.flowCase(3 * 86400)});
  EXPECT_FALSE(fs::exists(sound));
  EXPECT_EQ(readText(tried / "firstAttempt/log.snappyHexMesh"), "firstAttempt/log.snappyHexMesh");
  EXPECT_EQ(readText(tried / "movedMesh/log.checkMesh"), "movedMesh/log.checkMesh");
  EXPECT_EQ(std::distance(fs::directory_iterator(tried), {}), 2);
  results.removeFlowCasesAfter(std::nullopt);
  EXPECT_FALSE(fs::exists(tried));
}

TEST(ResultsFolder, KnowsWhatANewRunWouldMoveAside) {
  TemporaryFolder folder;
  const fs::path results = folder / "results";
  fs::create_directories(results / "lumen");
  for (const char* file : {"lumen/a.stl", "flow/0/l.stl", "previous/flow/0/l.stl", "scene.toml", "previous"})
    EXPECT_TRUE(ResultsFolder::holdsAsResult(results, results / file)) << file;
  for (const char* file : {"mine.stl", "../lumen/a.stl", "inputs/lumen/a.stl", "."})
    EXPECT_FALSE(ResultsFolder::holdsAsResult(results, results / file)) << file;
  fs::create_directory_symlink(results / "lumen", folder / "link");
  EXPECT_TRUE(ResultsFolder::holdsAsResult(results, folder / "link/a.stl"));
}

TEST(ResultsFolder, RefusesAFolderWithForeignFiles) {
  TemporaryFolder folder;
  writeText(folder / "thesis.tex", "years of work");
  const auto message = refusal([&] { ResultsFolder::fresh(folder.path()); });
  EXPECT_NE(message.find("thesis.tex"), std::string::npos) << message;
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1);
}

TEST(ResultsFolder, MovesTheFormerRunAsideAndLeavesTheUsersFiles) {
  TemporaryFolder folder;
  for (const char* run : {"first", "second"}) {
    const auto results = ResultsFolder::fresh(folder / "quick");
    atomicWrite(results.scene(), run);
    createFolder(results.checkpoint());
    writeText(results.path() / "notes.md", "mine");
  }
  ResultsFolder::fresh(folder / "quick");
  EXPECT_FALSE(fs::exists(folder / "quick/scene.toml"));
  EXPECT_FALSE(fs::exists(folder / "quick/checkpoint"));
  EXPECT_EQ(readText(folder / "quick/previous/scene.toml"), "second");
  EXPECT_EQ(readText(folder / "quick/notes.md"), "mine");
}

TEST(ResultsFolder, KeepsTheLastRunThatRecordedAnythingAndPicturesOfTheUser) {
  TemporaryFolder folder;
  const auto run = [&](const char* name, const char* timeSeries) {
    const auto results = ResultsFolder::fresh(folder / "quick");
    atomicWrite(results.scene(), name);
    atomicWrite(results.timeSeries(), timeSeries);
    writeText(results.path() / "mine.png", "mine");
  };
  run("whole", "day\n0\n");
  run("failed", "day\n");
  run("failed again", "day\n");
  EXPECT_EQ(readText(folder / "quick/previous/scene.toml"), "whole");
  run("second", "day\n0\n");
  const auto results = ResultsFolder::existing(folder / "quick");
  EXPECT_TRUE(results.moveFormerRun());
  EXPECT_EQ(readText(folder / "quick/previous/scene.toml"), "second");
  EXPECT_EQ(readText(folder / "quick/mine.png"), "mine");
  EXPECT_FALSE(results.moveFormerRun());
}

/// A results folder with a finished run and a former one in `previous/`, and the user's files in both.
class FinishedTwice : public ::testing::Test {
 protected:
  FinishedTwice() {
    for (const char* run : {"first", "second"}) {
      const auto results = ResultsFolder::fresh(quick);
      for (const char* inner : {"tissue/tissue_000000.vtp", "flow/3.5/system/controlDict", "scene.toml",
                                "timeSeries.csv", "summary.json", "checkpoint/state.bin"}) {
        fs::create_directories((quick / inner).parent_path());
        writeText(quick / inner, std::string(run) + "\nrow\n");
      }
    }
    for (const char* users : {"notes.md", "flow/mine/U", "previous/notes.md", "previous/mine/a/b",
                              "previous/flow/mine/U", "previous/tissue/my.vtp"}) {
      fs::create_directories((quick / users).parent_path());
      writeText(quick / users, users);
    }
  }
  /// Whether the second run is in `previous/` as a whole, and all of the user's files are somewhere in it.
  void expectMoved() const {
    for (const char* inner : {"tissue/tissue_000000.vtp", "flow/3.5/system/controlDict", "scene.toml",
                              "timeSeries.csv", "summary.json", "checkpoint/state.bin"}) {
      EXPECT_EQ(readText(quick / "previous" / inner), "second\nrow\n") << inner;
      EXPECT_FALSE(fs::exists(quick / inner)) << inner;
    }
    for (const char* users : {"notes.md", "previous/notes.md", "previous/mine/a/b", "previous/tissue/my.vtp"})
      EXPECT_EQ(readText(quick / users), users);
    EXPECT_EQ(readText(quick / "previous/flow/mine/U"), "flow/mine/U");
    EXPECT_EQ(readText(quick / "previous/flow/mine.previous/U"), "previous/flow/mine/U");
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(quick)) names.insert(entry.path().filename());
    EXPECT_EQ(names, (std::set<std::string>{".restenosisFoam", "notes.md", "previous"}));
  }

  TemporaryFolder folder;
  const fs::path quick = folder / "quick";
};

TEST_F(FinishedTwice, TheUsersFilesInThePreviousRunStay) {
  ResultsFolder::fresh(quick);
  expectMoved();
}

TEST_F(FinishedTwice, AMoveCutShortIsFinishedByTheNext) {
  fs::create_directory(quick / "previous.partial");
  for (const char* moved : {"timeSeries.csv", "flow", "summary.json"})
    fs::rename(quick / moved, quick / "previous.partial" / moved);
  ResultsFolder::existing(quick);
  expectMoved();
}

TEST_F(FinishedTwice, AMoveCutShortBetweenItsLastRenamesIsFinishedToo) {
  fs::create_directory(quick / "previous.partial");
  for (const char* moved : {"timeSeries.csv", "flow", "summary.json", "scene.toml", "tissue", "checkpoint"})
    fs::rename(quick / moved, quick / "previous.partial" / moved);
  fs::rename(quick / "previous", quick / "previous.replaced");
  {
    SCOPED_TRACE("before the new run is there");
    fs::copy(quick, folder / "before", fs::copy_options::recursive);
    ResultsFolder::fresh(quick);
    expectMoved();
  }
  fs::remove_all(quick);
  fs::rename(folder / "before", quick);
  fs::rename(quick / "previous.partial", quick / "previous");
  SCOPED_TRACE("before the replaced one is gone");
  fs::remove(quick / "previous.replaced/summary.json");
  ResultsFolder::fresh(quick);
  expectMoved();
}

TEST_F(FinishedTwice, LinksAreNotFollowed) {
  fs::create_directory(folder / "important");
  const auto important = [&](const std::string& name) {
    const fs::path file = folder / "important" / name;
    if (!fs::exists(file)) writeText(file, name);
    return file;
  };
  const auto replace = [&](const std::string& name, const fs::path& target) {
    fs::remove_all(quick / name);
    fs::create_symlink(target, quick / name);
  };
  for (const char* name : {"summary.json", "flow/3.5", "tissue/tissue_000000.vtp"})
    replace(name, important(fs::path(name).filename()));
  for (const char* name : {"flow", "checkpoint", "tissue", "lumen", "compare"}) {
    SCOPED_TRACE(name);
    if (fs::exists(quick / name)) fs::rename(quick / name, quick / "aside");
    replace(name, folder / "important");
    const auto message = refusal([&] { ResultsFolder::existing(quick); });
    EXPECT_NE(message.find((quick / name).string() + " is a link"), std::string::npos) << message;
    fs::remove(quick / name);
    if (fs::exists(quick / "aside")) fs::rename(quick / "aside", quick / name);
  }
  const auto results = ResultsFolder::existing(quick);
  atomicWrite(results.summary(), "mine");
  EXPECT_EQ(readText(quick / "summary.json"), "mine");
  replace("profile.csv.partial", important("partial"));
  atomicWrite(results.profile(), "mine");
  results.removeFlowCasesAfter(std::nullopt);
  EXPECT_FALSE(fs::is_symlink(quick / "flow/3.5"));

  replace("flow", folder / "important");
  replace("previous/flow", folder / "important");
  EXPECT_TRUE(results.moveFormerRun());
  EXPECT_TRUE(fs::is_symlink(quick / "previous/flow"));
  replace("previous", folder / "important");
  replace("previous.partial", folder / "important");
  writeText(quick / "timeSeries.csv", "day\n0\n");
  EXPECT_TRUE(results.moveFormerRun());
  EXPECT_TRUE(fs::exists(quick / "previous/timeSeries.csv"));
  EXPECT_FALSE(fs::is_symlink(quick / "previous"));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder / "important"), {}), 4);
  for (const char* name : {"summary.json", "3.5", "tissue_000000.vtp", "partial"})
    EXPECT_EQ(readText(folder / "important" / name), name);
}

TEST(ResultsFolder, LinksAmongOtherResultsAreRefused) {
  TemporaryFolder folder;
  fs::create_directory(folder / "important");
  for (const char* name : {"flow", "foam", "lbm", "deployment", "runs", "runs/a"}) {
    const fs::path link = folder / "sweep" / name;
    ResultsFolder::forOutput(folder / "sweep");
    fs::create_directories(link.parent_path());
    fs::create_directory_symlink(folder / "important", link);
    const auto message = refusal([&] { ResultsFolder::forOutput(folder / "sweep"); });
    EXPECT_NE(message.find(link.string() + " is a link"), std::string::npos) << message;
    fs::remove(link);
  }
  fs::create_directory_symlink(folder / "important", folder / "sweep/mine");
  EXPECT_NO_THROW(ResultsFolder::forOutput(folder / "sweep"));
}

TEST(ResultsFolder, TheLockIsNotTakenThroughALink) {
  TemporaryFolder folder;
  ResultsFolder::fresh(folder / "quick");
  writeText(folder / "important", "mine");
  fs::remove(folder / "quick/.restenosisFoam");
  fs::create_symlink(folder / "important", folder / "quick/.restenosisFoam");
  EXPECT_NE(refusal([&] { ResultsFolder::fresh(folder / "quick"); }).find("is a link"), std::string::npos);
  EXPECT_EQ(readText(folder / "important"), "mine");
  fs::create_directory_symlink(folder / "elsewhere", folder / "link");
  fs::create_directory(folder / "elsewhere");
  ResultsFolder::fresh(folder / "link");
  EXPECT_TRUE(fs::exists(folder / "elsewhere/.restenosisFoam"));
}

TEST(ResultsFolder, KeepsEverythingForAResume) {
  TemporaryFolder folder;
  {
    const auto results = ResultsFolder::fresh(folder / "quick");
    atomicWrite(results.scene(), "scene");
  }
  ResultsFolder::existing(folder / "quick");
  EXPECT_EQ(readText(folder / "quick/scene.toml"), "scene");
  EXPECT_NE(refusal([&] { ResultsFolder::existing(folder / "slow"); }), "");
  EXPECT_NE(refusal([&] { ResultsFolder::existing(folder.path()); }), "");
}

TEST(ResultsFolder, IsUsedByOneRunAtATime) {
  TemporaryFolder folder;
  {
    const auto first = ResultsFolder::fresh(folder / "quick");
    const auto message = refusal([&] { ResultsFolder::fresh(folder / "quick"); });
    EXPECT_NE(message.find("another run (process "), std::string::npos) << message;
    EXPECT_NE(refusal([&] { ResultsFolder::existing(folder / "quick"); }), "");
  }
  EXPECT_NO_THROW(ResultsFolder::existing(folder / "quick"));
}

TEST(ResultsFolder, SaysWhenItCannotBeRead) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may read everything";
  TemporaryFolder folder;
  fs::create_directory(folder / "closed");
  fs::permissions(folder / "closed", fs::perms::none);
  for (const auto& name : {"closed", "closed/below"}) {
    EXPECT_NE(refusal([&] { ResultsFolder::fresh(folder / name); }).find("choose another"),
              std::string::npos);
    EXPECT_NE(refusal([&] { ResultsFolder::existing(folder / name); }).find("Permission denied"),
              std::string::npos);
  }
  fs::permissions(folder / "closed", fs::perms::owner_all);
}

TEST(ResultsFolder, SaysWhenItCannotBeWritten) {
  TemporaryFolder folder;
  writeText(folder / "file", "");
  EXPECT_NE(refusal([&] { ResultsFolder::fresh(folder / "file/quick"); }).find("choose another"),
            std::string::npos);
  EXPECT_NE(refusal([] { ResultsFolder::fresh("/proc/quick"); }), "");
}

}  // namespace
}  // namespace restenosis

#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <functional>
#include <optional>

#include "AtomicFile.h"
#include "ResultsFolder.h"
#include "TemporaryFolder.h"

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

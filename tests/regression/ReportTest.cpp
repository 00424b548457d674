#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/Process.h"
#include "tests/support/SyntheticResults.h"
#include "tests/support/TemporaryFolder.h"

namespace restenosis {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

/// Two made-up runs, `a` and `b`, and what `report` makes of them.
class Report : public ::testing::Test {
 protected:
  void SetUp() override {
    if (std::system("/usr/bin/python3 -c 'import matplotlib, vtkmodules' >/dev/null 2>&1") != 0)
      GTEST_SKIP() << "install python3-matplotlib and python3-vtk9 to run this test";
  }
  /// Made-up results with cells that grow, and a picture in place of those that `report` would draw.
  void write(const fs::path& run, const char* depth) const {
    fs::create_directories(run);
    SyntheticResults().write(run);
    writeText(run / "scene.toml", fmt::format("[scene]\ntitle = \"a < b\"\nduration = \"20 d\"\n[stent]\n"
                                              "deploymentDepth = \"{}\"\n[cellCycle]\n",
                                              depth));
    fs::copy_file(RESTENOSIS_SOURCE_DIR "/docs/pictures/quickVessel.png", run / "vessel.png");
  }
  ProcessEnd report(std::vector<std::string> arguments) const {
    std::vector<std::string> command{RESTENOSIS_PROGRAM, "report"};
    command.insert(command.end(), arguments.begin(), arguments.end());
    return Process(command, folder.path()).wait(200s);
  }
  std::string page(const char* name) const { return readText(folder / name); }
  /// Opens a page in Chromium.
  void expectUsable(const fs::path& page, std::vector<std::string> options = {}) const {
    std::vector<std::string> command{"/usr/bin/python3", "-B",
                                     RESTENOSIS_SOURCE_DIR "/tests/regression/checkReport.py", page};
    command.insert(command.end(), options.begin(), options.end());
    const ProcessEnd end = Process(command, folder.path()).wait(900s);
    EXPECT_EQ(end.status, 0) << toString(end);
  }
  static bool chromiumPresent() { return std::system("command -v chromium >/dev/null") == 0; }

  TemporaryFolder folder;
};

TEST_F(Report, SaysWhatCameOutAndWhereItComesFrom) {
  write(folder / "a", "110 um");
  const ProcessEnd end = report({"a"});
  ASSERT_EQ(end.status, 0) << toString(end);
  const std::string text = page("a/report.html");
  for (const char* said :
       {"new tissue fills 20 % of the stented lumen", "Thickness of new tissue", "neointimaThickness_um",
        "a &lt; b", "How to cite", "What this does not show", "data:image/webp;base64,", "\"kind\":\"grid\""})
    EXPECT_NE(text.find(said), std::string::npos) << said;
  for (const char* reference : {"src=\"http", "href=\"http", "import(", "fetch("})
    EXPECT_EQ(text.find(reference), std::string::npos) << reference;
  EXPECT_LT(text.size(), 3'000'000u);
  EXPECT_TRUE(text.ends_with("</html>\n"));
  EXPECT_FALSE(fs::exists(folder / "a/report.html.log"));
}

TEST_F(Report, OfARunThatWasKilledIsOfItsLastRecord) {
  write(folder / "a", "110 um");
  fs::remove(folder / "a/summary.json");
  const ProcessEnd end = report({"a"});
  ASSERT_EQ(end.status, 0) << toString(end);
  EXPECT_NE(page("a/report.html").find("The run has not come to its end"), std::string::npos);
}

TEST_F(Report, LaysRunsAndStudiesSideBySide) {
  write(folder / "a", "110 um");
  for (const char* run : {"study/runs/one", "study/runs/two"}) write(folder / run, "90 um");
  const ProcessEnd end = report({"a", "study"});
  ASSERT_EQ(end.status, 0) << toString(end);
  const std::string text = page("report-a-study.html");
  for (const char* said :
       {"3 runs side by side", "stent.deploymentDepth", "110 um", "90 um", "2 runs, shown by"})
    EXPECT_NE(text.find(said), std::string::npos) << said;
  EXPECT_EQ(report({"a", "study", "-o", "other.html"}).status, 0);
  EXPECT_EQ(page("other.html"), text);
}

TEST_F(Report, DrawsTheVesselDayByDay) {
  if (std::getenv("DISPLAY") == nullptr && std::system("command -v Xvfb >/dev/null") != 0)
    GTEST_SKIP() << "install xvfb to run this test";
  write(folder / "a", "110 um");
  const ProcessEnd end = report({"a", "--animation"});
  ASSERT_EQ(end.status, 0) << toString(end);
  EXPECT_TRUE(readText(folder / "a/animation.gif").starts_with("GIF89a"));
  EXPECT_GT(fs::file_size(folder / "a/animation.gif"), 20000U) << "not blank";
  EXPECT_FALSE(fs::exists(folder / "a/animation.log"));
  fs::remove(folder / "a/tissue.pvd");
  EXPECT_EQ(report({"a", "--animation"}).status, 2);
}

TEST_F(Report, RefusesWhatIsNoResult) {
  write(folder / "a", "110 um");
  fs::create_directory(folder / "empty");
  const ProcessEnd end = report({"a", "empty", "nowhere"});
  EXPECT_EQ(end.status, 2) << toString(end);
  EXPECT_NE(end.err.find("empty: holds no results"), std::string::npos) << end.err;
  EXPECT_NE(end.err.find("nowhere: there is no such folder"), std::string::npos) << end.err;
  EXPECT_EQ(report({}).status, 2);
  EXPECT_EQ(report({"a", "-o", "missing/page.html"}).status, 2);
  EXPECT_EQ(report({"a", "-o", "empty"}).status, 2);
  EXPECT_FALSE(fs::exists(folder / "a/report.html")) << "nothing is written";
}

TEST_F(Report, SaysThatASeriesIsNoTable) {
  fs::create_directory(folder / "a");
  writeText(folder / "a/timeSeries.csv", "day,agents\n1,many\n");
  const ProcessEnd end = report({"a"});
  EXPECT_EQ(end.status, 1) << toString(end);
  EXPECT_NE(end.err.find("timeSeries.csv is no table of numbers"), std::string::npos) << end.err;
}

TEST_F(Report, WorksInABrowserOnADeskAndOnAPhone) {
  if (!chromiumPresent()) GTEST_SKIP() << "install chromium to run this test";
  write(folder / "a", "110 um");
  ASSERT_EQ(report({"a"}).status, 0);
  expectUsable(folder / "a/report.html");
}

TEST_F(Report, OfSeveralWorksInABrowser) {
  if (!chromiumPresent()) GTEST_SKIP() << "install chromium to run this test";
  write(folder / "a", "110 um"), write(folder / "b", "90 um");
  ASSERT_EQ(report({"a", "b", "-o", "ab.html"}).status, 0);
  expectUsable(folder / "ab.html", {"--no-lumen"});
}

}  // namespace
}  // namespace restenosis

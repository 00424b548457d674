#include <fmt/format.h>
#include <gtest/gtest.h>

#include "bridge/output/Figures.h"
#include "tests/support/EnvironmentVariable.h"
#include "tests/support/Process.h"
#include "tests/support/SyntheticResults.h"
#include "tests/support/TemporaryFolder.h"

namespace restenosis {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

bool pythonHasPackages() {
  return std::system("/usr/bin/python3 -c 'import matplotlib, vtkmodules' >/dev/null 2>&1") == 0 &&
         (std::getenv("DISPLAY") != nullptr || std::system("command -v Xvfb >/dev/null") == 0);
}

TEST(Figures, DrawsEveryPictureAndPutsAllOnOnePage) {
  if (!pythonHasPackages())
    GTEST_SKIP() << "install python3-matplotlib, python3-vtk9 and xvfb to run this test";
  TemporaryFolder folder;
  SyntheticResults().write(folder.path());
  writeText(folder / "scene.toml", "[scene]\ntitle = \"a < b\"\n");
  EXPECT_EQ(Figures().draw(folder.path()), "") << readText(folder / "figures.log");
  for (const char* name : {"vessel.png", "section.png", "growth.png", "lumen.png", "lumen3d.png"}) {
    const auto picture = readText(folder / name);
    EXPECT_TRUE(picture.starts_with("\x89PNG")) << name;
    // A blank picture of these sizes compresses to a few kilobytes.
    EXPECT_GT(picture.size(), 20000u) << name;
  }
  for (const char* name : {"section.pdf", "growth.pdf", "lumen.pdf"})
    EXPECT_TRUE(readText(folder / name).starts_with("%PDF")) << name;

  const auto page = readText(folder / "report.html");
  std::size_t pictures = 0;
  for (auto at = page.find("<img src=\"data:image/"); at != std::string::npos;
       at = page.find("<img src=\"data:image/", at + 1))
    ++pictures;
  EXPECT_EQ(pictures, 2u) << "vessel and section; curves and lumen are drawn by the page";
  EXPECT_NE(page.find("\"kind\":\"grid\""), std::string::npos);
  EXPECT_NE(page.find("title = &quot;a &lt; b&quot;"), std::string::npos) << "the scene, escaped";
  EXPECT_NE(page.find("neointimaThickness_um"), std::string::npos);
  EXPECT_NE(page.find("How to cite"), std::string::npos);
  EXPECT_EQ(page.find("src=\"http"), std::string::npos);
  EXPECT_TRUE(page.ends_with("</html>\n"));
}

TEST(Example, ReadsARunAndDrawsIt) {
  if (std::system("/usr/bin/python3 -c 'import matplotlib, pandas, vtkmodules' >/dev/null 2>&1") != 0)
    GTEST_SKIP() << "install python3-matplotlib, python3-pandas and python3-vtk9 to run this test";
  TemporaryFolder folder;
  SyntheticResults().write(folder.path());
  const ProcessEnd end =
      Process({RESTENOSIS_SOURCE_DIR "/examples/notebook.py", folder.path().string()}, folder.path())
          .wait(60s);
  EXPECT_EQ(end.status, 0) << toString(end);
  EXPECT_GT(fs::file_size(folder / "examples.png"), 20000U);
}

TEST(Figures, AreDrawnWhateverTheUserHasSetForOtherPrograms) {
  if (!pythonHasPackages())
    GTEST_SKIP() << "install python3-matplotlib, python3-vtk9 and xvfb to run this test";
  TemporaryFolder folder, home, path;
  fs::create_directory(folder / "results");
  SyntheticResults().write(folder / "results");
  const std::string broken = "text.usetex: True\nbackend: none\n\xff";
  fs::create_directories(home / ".config/matplotlib");
  for (const fs::path& file : {home / ".config/matplotlib/matplotlibrc", home / "matplotlibrc"})
    writeText(file, broken);
  for (const char* module : {"numpy", "matplotlib", "json"}) {
    writeText(path / (std::string(module) + ".py"), "raise ImportError('of the user')\n");
    writeText(home / (std::string(module) + ".py"), "raise ImportError('of the working folder')\n");
  }
  const EnvironmentVariable home_("HOME", home.path().c_str()), pythonPath("PYTHONPATH", path.path().c_str()),
      pythonHome("PYTHONHOME", "/nonexistent"), start("PYTHONSTARTUP", "/nonexistent"),
      settings("MATPLOTLIBRC", (home / "matplotlibrc").c_str()), backend("MPLBACKEND", "none"),
      configuration("MPLCONFIGDIR", "/nonexistent"), locale("LC_ALL", "C"), display("DISPLAY", ":4711");
  const fs::path before = fs::current_path();
  fs::current_path(home.path());
  EXPECT_EQ(Figures().draw(folder / "results"), "") << readText(folder / "results/figures.log");
  fs::current_path(before);
  for (const char* name :
       {"vessel.png", "section.png", "growth.png", "lumen.png", "lumen3d.png", "report.html", "view.pvsm"})
    EXPECT_TRUE(fs::exists(folder / "results" / name)) << name;
  EXPECT_FALSE(fs::exists(folder / "results/.figures"));
  EXPECT_FALSE(fs::exists(home / ".cache")) << "nothing is left with the user";
}

TEST(Figures, ThePageIsWrittenWithoutPicturesThatCannotBeDrawn) {
  TemporaryFolder folder;
  fs::create_directory(folder / "results");
  SyntheticResults().write(folder / "results");
  writeText(folder / "results/growth.png", "of a former day");
  // Without the packages of Debian
  writeText(folder / "python", "#!/bin/sh\nexec /usr/bin/python3 -S \"$@\"\n");
  fs::permissions(folder / "python", fs::perms::owner_all);
  const fs::path script = RESTENOSIS_SOURCE_DIR "/bridge/output/figures";
  const auto problem = Figures(folder / "python", script, 60s).draw(folder / "results");
  EXPECT_NE(problem.find("install the package python3-numpy (No module named 'numpy')"), std::string::npos)
      << problem;
  EXPECT_NE(problem.find("figures.log"), std::string::npos) << problem;
  const auto page = readText(folder / "results/report.html");
  EXPECT_NE(page.find("neointimaThickness_um"), std::string::npos);
  EXPECT_EQ(page.find("<img"), std::string::npos) << "a picture of another state";
  EXPECT_TRUE(page.ends_with("</html>\n"));
}

TEST(Figures, DrawsWhatThereIsBeforeAnyFlowAndForOneFrame) {
  if (!pythonHasPackages())
    GTEST_SKIP() << "install python3-matplotlib, python3-vtk9 and xvfb to run this test";
  TemporaryFolder folder;
  SyntheticResults results;
  results.frames = 1;
  results.write(folder.path());
  EXPECT_EQ(Figures().draw(folder.path()), "") << readText(folder / "figures.log");
  for (const char* name : {"vessel.png", "section.png", "section.pdf", "lumen3d.png"})
    EXPECT_TRUE(fs::exists(folder / name)) << name;
  for (const char* none : {"growth.png", "growth.pdf", "lumen.png", "lumen.pdf"})
    EXPECT_FALSE(fs::exists(folder / none)) << none;
}

TEST(Figures, OfALumenWithoutTissueShowNoGrowth) {
  if (!pythonHasPackages())
    GTEST_SKIP() << "install python3-matplotlib, python3-vtk9 and xvfb to run this test";
  TemporaryFolder folder;
  SyntheticResults().write(folder.path());
  fs::remove(folder / "tissue.pvd");
  EXPECT_EQ(Figures().draw(folder.path()), "") << readText(folder / "figures.log");
  for (const char* name : {"lumen.png", "lumen3d.png"}) EXPECT_TRUE(fs::exists(folder / name)) << name;
  for (const char* none : {"vessel.png", "section.png", "growth.png"})
    EXPECT_FALSE(fs::exists(folder / none)) << none;
}

TEST(Figures, ShowALumenFromAFileInSpaceAndOnThePage) {
  if (!pythonHasPackages())
    GTEST_SKIP() << "install python3-matplotlib, python3-vtk9 and xvfb to run this test";
  TemporaryFolder folder;
  SyntheticResults().write(folder.path());
  writeText(folder / "scene.toml", "[vessel]\nlumenSurface = \"a.stl\"\n");
  std::filesystem::remove(folder / "tissue.pvd");
  EXPECT_EQ(Figures().draw(folder.path()), "") << readText(folder / "figures.log");
  for (const char* none : {"vessel.png", "growth.png", "lumen.png", "section.png"})
    EXPECT_FALSE(std::filesystem::exists(folder / none)) << none;
  EXPECT_TRUE(std::filesystem::exists(folder / "lumen3d.png"));
  EXPECT_NE(readText(folder / "report.html").find("\"kind\":\"surface\""), std::string::npos);
}

TEST(Figures, SayWhenThereIsNothingToDraw) {
  if (!pythonHasPackages())
    GTEST_SKIP() << "install python3-matplotlib, python3-vtk9 and xvfb to run this test";
  TemporaryFolder folder;
  EXPECT_NE(Figures().draw(folder.path()).find("holds no results to draw"), std::string::npos);
}

TEST(Figures, TheFrontOfATradeoffEndsAtTheReference) {
  if (!pythonHasPackages())
    GTEST_SKIP() << "install python3-matplotlib, python3-vtk9 and xvfb to run this test";
  TemporaryFolder folder;
  // b's second value is beaten by its reference; a's reference says nothing about b
  writeText(folder / "tradeoff.csv",
            "setting,value,seconds,error,meaning\n"
            "a,fine,40,0,thickness against a = fine\n"
            "a,coarse,10,0.2,thickness against a = fine\n"
            "b,fine,60,0,thickness against b = fine\n"
            "b,slow,70,0.01,thickness against b = fine\n"
            "b,coarse,50,0.3,thickness against b = fine\n");
  writeText(folder / "fronts.py",
            fmt::format(R"(import pathlib, sys
sys.path.insert(0, "{}")
import tradeoff
fronts = tradeoff.fronts(tradeoff.read(pathlib.Path("{}")))
print([[row["setting"] + row["value"] for row in front] for front in fronts])
)",
                        RESTENOSIS_SOURCE_DIR "/bridge/output/figures", folder.path().string()));
  const ProcessEnd end =
      Process({"/usr/bin/python3", "-B", (folder / "fronts.py").string()}, folder.path()).wait(60s);
  EXPECT_EQ(end.out, "[['acoarse', 'afine'], ['bcoarse', 'bfine']]\n") << toString(end);
  EXPECT_EQ(Figures().draw(folder.path()), "") << readText(folder / "figures.log");
  EXPECT_GT(readText(folder / "tradeoff.png").size(), 10000u);
}

TEST(Figures, NamesWhatIsMissing) {
  TemporaryFolder folder;
  EXPECT_NE(Figures("/nonexistent/python3", "figures", 5s).draw(folder.path()).find("RESTENOSIS_PYTHON"),
            std::string::npos);
  writeText(folder / "fails.py", "import sys\nsys.exit('install the package python3-matplotlib')\n");
  const auto problem = Figures("/usr/bin/python3", folder / "fails.py", 60s).draw(folder.path());
  EXPECT_NE(problem.find("install the package python3-matplotlib"), std::string::npos) << problem;
  EXPECT_NE(problem.find("figures.log"), std::string::npos) << problem;
}

TEST(Figures, NameAnInterpreterThatFailsWithoutAWord) {
  TemporaryFolder folder;
  const auto problem = Figures("/bin/false", "figures", 60s).draw(folder.path());
  EXPECT_NE(problem.find("/bin/false: exit status 1"), std::string::npos) << problem;
}

TEST(Figures, AreGivenUpWhenTheUserAsks) {
  TemporaryFolder folder;
  writeText(folder / "hang.py", "import time\ntime.sleep(60)\n");
  const std::atomic<bool> stop{true};
  EXPECT_NE(
      Figures("/usr/bin/python3", folder / "hang.py", 60s).draw(folder.path(), &stop).find("interrupted"),
      std::string::npos);
}

TEST(Figures, GivesUpOnAProcessThatHangs) {
  TemporaryFolder folder;
  writeText(folder / "hang.py", "import time\ntime.sleep(60)\n");
  const auto start = std::chrono::steady_clock::now();
  EXPECT_NE(Figures("/usr/bin/python3", folder / "hang.py", 1s).draw(folder.path()).find("given up"),
            std::string::npos);
  EXPECT_LT(std::chrono::steady_clock::now() - start, 10s);
}

}  // namespace
}  // namespace restenosis

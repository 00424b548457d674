#include <fmt/format.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkXMLPolyDataReader.h>

#include <cmath>
#include <regex>
#include <sstream>

#include "tests/support/WholeProgram.h"

namespace restenosis {
namespace {

class WholeRun : public WholeProgram {
 protected:
  /// Files that a .pvd series names, in its order.
  std::vector<std::string> filesOf(const std::string& series) const {
    const std::string text = readText(folder.path() / series);
    const std::regex entry("file=\"([^\"]+)\"");
    std::vector<std::string> files;
    for (std::sregex_iterator match(text.begin(), text.end(), entry), end; match != end; ++match)
      files.push_back((folder.path() / series).parent_path() / (*match)[1].str());
    return files;
  }
  static vtkSmartPointer<vtkPolyData> readPolyData(const std::string& file) {
    const auto reader = vtkSmartPointer<vtkXMLPolyDataReader>::New();
    reader->SetFileName(file.c_str());
    reader->Update();
    return reader->GetOutput();
  }
};

TEST_F(WholeRun, WritesEveryFileOfTheContract) {
  ASSERT_EXIT_STATUS(run({"run", scene("tiny", tinyScene), "-o", "out"}), 0);

  const auto json = summary("out");
  EXPECT_EQ(json["scene"], "tiny");
  EXPECT_EQ(json["title"], "Tiny");
  EXPECT_EQ(json["status"], "finished");
  EXPECT_EQ(json["seed"], 1);
  EXPECT_GE(json["threads"], 1);
  EXPECT_FALSE(std::string(json["version"]).empty());
  EXPECT_TRUE(std::regex_match(std::string(json["stateDigest"]), std::regex("[0-9a-f]{16,}")));
  EXPECT_GT(json["packing"]["bonds"], json["packing"]["cells"]);
  EXPECT_LT(std::abs(double(json["packing"]["ielMeanRadialMoveOnRelease_um"])), 0.1);
  EXPECT_EQ(json["packing"]["cellsOutsideLaminae"], 0);
  EXPECT_EQ(json["deployment"]["agentsLumenwardOfStruts"], 0);
  EXPECT_EQ(json["deployment"]["cellsOutsideEel"], 0);
  EXPECT_GT(json["deployment"]["ielRadiusUnderStruts_um"], 240) << "0.4 mm across, struts 40 um deep";
  EXPECT_GT(json["deployment"]["largestBondStrain"], 0);
  EXPECT_GT(json["injury"]["removedIelAgents"], 0);
  EXPECT_GT(json["injury"]["syntheticCells"], json["injury"]["removedIelAgents"]);
  EXPECT_GE(json["flow"]["solvesDone"], 2);
  EXPECT_GT(json["flow"]["solvesSkipped"], 0);
  EXPECT_FALSE(json["flow"]["skippedBecause"].empty());
  for (const char* part : {"deploy", "relax", "biology", "surface", "mesh", "flow", "output"}) {
    ASSERT_TRUE(json["parts"].contains(part)) << part;
    EXPECT_GE(json["parts"][part]["seconds"], 0.0) << part;
    EXPECT_TRUE(json["parts"][part].contains("peakMemory_MiB")) << part;
  }

  const CsvColumns series(folder / "out/timeSeries.csv");
  const std::vector<std::string> first = {"day",
                                          "agents",
                                          "smc",
                                          "divisions",
                                          "neointimaThickness_um",
                                          "neointimaAreaFraction",
                                          "minLumenArea_mm2",
                                          "coverage",
                                          "wssMean_Pa",
                                          "wssLowAreaFraction",
                                          "flowSolved"};
  ASSERT_GE(series.names.size(), first.size());
  EXPECT_TRUE(std::equal(first.begin(), first.end(), series.names.begin()));
  ASSERT_EQ(series.rows(), 9u);  // every half day from day 0 to day 4
  for (std::size_t row = 0; row < 9; ++row) {
    EXPECT_NEAR(series.values.at("day")[row].value(), 0.5 * static_cast<double>(row), 1e-9);
    EXPECT_EQ(series.values.at("agents")[row].value() - series.values.at("agents")[0].value(),
              series.values.at("divisions")[row].value());
  }
  EXPECT_FALSE(series.values.at("wssMean_Pa").front().has_value()) << "no flow before the first covered cell";
  EXPECT_GT(series.last("wssMean_Pa"), 0);
  EXPECT_GT(series.last("neointimaThickness_um"), 5) << "the neointima grows";
  EXPECT_GT(series.last("divisions"), 20);
  EXPECT_EQ(json["final"]["divisions"], series.last("divisions"));
  EXPECT_EQ(json["agents"], series.last("agents"));

  const CsvColumns profile(folder / "out/profile.csv");
  EXPECT_EQ(profile.names,
            (std::vector<std::string>{
                "z_mm", "lumenArea_mm2", "neointimaAreaFraction", "neointimaThickness_um", "intimaArea_mm2",
                "mediaArea_mm2", "relativeIntimaArea", "intimaCells", "intimaInCycle", "intimaMatrixShare"}));
  EXPECT_GE(profile.last("z_mm"), 0.2);
  EXPECT_LE(profile.last("z_mm"), 0.24);

  const CsvColumns map(folder / "out/thicknessMap.csv");
  ASSERT_EQ(map.rows(), 360 * profile.rows());
  for (std::size_t plane = 0; plane < profile.rows(); ++plane) {
    double mean = 0;
    for (std::size_t ray = 0; ray < 360; ++ray)
      mean += map.values.at("neointimaThickness_um")[360 * plane + ray].value() / 360;
    EXPECT_NEAR(mean, profile.values.at("neointimaThickness_um")[plane].value(), 1e-4);
  }

  const auto tissue = filesOf("out/tissue.pvd"), lumen = filesOf("out/lumen.pvd");
  ASSERT_EQ(tissue.size(), series.rows());
  ASSERT_EQ(lumen.size(), series.rows());
  for (std::size_t row = 0; row < series.rows(); ++row)
    EXPECT_EQ(readPolyData(tissue[row])->GetNumberOfPoints(), series.values.at("agents")[row].value());
  const auto agents = readPolyData(tissue.back());
  for (const char* name : {"radius", "kind", "state", "stress", "NO"})
    EXPECT_TRUE(agents->GetPointData()->HasArray(name)) << name;
  const auto surface = readPolyData(lumen.back());
  EXPECT_GT(surface->GetNumberOfCells(), 100);
  EXPECT_TRUE(surface->GetPointData()->HasArray("neointimaThickness"));
  EXPECT_TRUE(exists("out/checkpoint"));
}

TEST_F(WholeRun, RecordsEveryStepWhereTheIntervalIsShorter) {
  const std::string tiny = scene("tiny", with(tinyScene, "\"4 d\"", "\"6 h\""));
  for (const char* interval : {"1.3 h", "1e-310 d"}) {
    SCOPED_TRACE(interval);
    ASSERT_EXIT_STATUS(run({"run", tiny, "-o", "out", "--set", std::string("output.interval=") + interval}),
                       0);
    const std::string series = readText(folder / "out/timeSeries.csv");
    EXPECT_EQ(std::ranges::count(series, '\n'), 1 + 4) << "heading; 0, 2, 4 and 6 h";
  }
}

TEST_F(WholeRun, RecordsTheStepNextToEachIntervalAndOfTwoTheFirst) {
  const std::string tiny = scene("tiny", with(tinyScene, "\"4 d\"", "\"24 h\""));
  ASSERT_EXIT_STATUS(run({"run", tiny, "-o", "out", "--set", "output.interval=3 h"}), 0);
  std::istringstream series(readText(folder / "out/timeSeries.csv"));
  std::vector<int> hours;
  std::string line;
  for (std::getline(series, line); std::getline(series, line);)
    hours.push_back(static_cast<int>(std::lround(24 * std::stod(line))));
  EXPECT_EQ(hours, (std::vector<int>{0, 2, 6, 8, 12, 14, 18, 20, 24}));
}

TEST_F(WholeRun, TheSceneAsResolvedRunsTheSame) {
  const std::string tiny = scene("tiny", with(tinyScene, "\"4 d\"", "\"1 d\""));
  ASSERT_EXIT_STATUS(run({"run", tiny, "-o", "out"}), 0);
  ASSERT_EXIT_STATUS(run({"run", "out/scene.toml", "-o", "again"}), 0);
  EXPECT_EQ(digest("again"), digest("out"));
  // The first line names the file it was made from.
  const auto body = [](const std::string& text) { return text.substr(text.find('\n')); };
  EXPECT_EQ(body(readText(folder / "again/scene.toml")), body(readText(folder / "out/scene.toml")));
}

TEST_F(WholeRun, ThePlanSaysWhatASettingDoesNotDo) {
  const std::string lattice = scene("lattice", with(tinyScene, "\"analytic\"", "\"lbm\""));
  const ProcessEnd plan =
      run({"check", lattice, "--set", "coupling.remesh=onDemand", "--set", "flow.straightEnds=0.3 mm"});
  ASSERT_EXIT_STATUS(plan, 0);
  EXPECT_NE(plan.out.find("every solve makes a new lattice"), std::string::npos) << plan.out;
  EXPECT_NE(plan.out.find("0.3 mm of straight tube"), std::string::npos) << plan.out;
}

TEST_F(WholeRun, AnUninjuredWallRestsAndNeedsNoFlow) {
  std::string text = with(tinyScene, "removeIel = true\n", "");
  const auto stent = text.find("[stent]"), injury = text.find("[injury]");
  text.erase(stent, injury - stent);
  // OpenFOAM, and none on the PATH: a solve that is made after all fails the run.
  const std::string intact = scene("intact", with(text, "\"analytic\"", "\"foam\""));
  const ProcessEnd plan = run({"check", intact});
  ASSERT_EXIT_STATUS(plan, 0);
  EXPECT_NE(plan.out.find("no cell is exposed, none is covered, and the flow is expected never to be due"),
            std::string::npos)
      << plan.out;
  EXPECT_NE(plan.out.find("it will be refused: 'cellSize' in [foam] is 90 um"), std::string::npos)
      << plan.out;
  EXPECT_FALSE(exists("results")) << "check writes nothing";
  ASSERT_EXIT_STATUS(run({"run", intact}, {{"PATH", "/nonexistent"}}), 0);
  const auto json = summary("results/intact");
  EXPECT_EQ(json["final"]["divisions"], 0);
  EXPECT_EQ(json["flow"]["solvesDone"], 0);
  EXPECT_EQ(json["flow"]["skippedBecause"].begin().key(), "no cell is covered by endothelium");
}

TEST_F(WholeRun, EndsOnTheDayThatTheLumenClosesWhateverIsRecorded) {
  const std::string closing = scene("closing", R"([scene]
duration = "8 d"
step = "2 h"
[vessel]
length = "0.2 mm"
lumenDiameter = "0.4 mm"
wallThickness = "0.1 mm"
fixedEnds = 1
[injury]
removeIel = true
synthetic = "all"
[mechanics]
[cellCycle]
[output]
pictures = false
)");
  std::vector<std::string> digests;
  for (const char* interval : {"4 d", "4 h"}) {
    ASSERT_EXIT_STATUS(
        run({"run", closing, "-o", "out", "--set", fmt::format("output.interval={}", interval)}), 0);
    const auto json = summary("out");
    EXPECT_EQ(json["status"], "occluded");
    digests.push_back(json["stateDigest"]);
    const CsvColumns series(folder / "out/timeSeries.csv");
    const double day = series.last("day");
    EXPECT_GT(day, 0);
    EXPECT_LT(day, 8);
    EXPECT_EQ(day, std::round(day));
    EXPECT_EQ(series.last("minLumenArea_mm2"), 0);
    EXPECT_EQ(json["final"]["day"], day);
    EXPECT_EQ(json["final"]["agents"], series.last("agents"));
    const auto agents = readPolyData(filesOf("out/tissue.pvd").back())->GetNumberOfPoints();
    EXPECT_EQ(agents, series.last("agents")) << "the last state is among those recorded";
  }
  EXPECT_EQ(digests[0], digests[1]);
}

}  // namespace
}  // namespace restenosis

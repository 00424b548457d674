#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkXMLPolyDataReader.h>

#include <sstream>

#include "bridge/output/ResultsFolder.h"
#include "bridge/surface/StlFile.h"
#include "tests/support/OpenFoamPresent.h"
#include "tests/support/SweptTube.h"
#include "tests/support/TubeSurface.h"
#include "tests/support/WholeProgram.h"

namespace restenosis {
namespace {

using Compare = WholeProgram;

constexpr const char* straightTube = R"([scene]
duration = "1 h"
fidelity = "draft"
[vessel]
length = "0.6 mm"
lumenDiameter = "1.8 mm"
[flow]
drive = "flowRate"
meanVelocity = "0.133 m/s"
[lbm]
dx = "60 um"
[output]
pictures = false
)";

TEST_F(Compare, BothBackendsFindPoiseuillesStressInATube) {
  RESTENOSIS_NEEDS_OPENFOAM();
  ASSERT_EXIT_STATUS(run({"compare", scene("straight", straightTube), "-o", "out"}), 0);
  const auto json = nlohmann::json::parse(readText(folder / "out/compare.json"));
  const double exact = 4.0 * 2.7e-3 * 0.133 / 0.9e-3;
  const auto& wall = json["wss"]["wall"];
  EXPECT_NEAR(wall["foamMean_Pa"], exact, 0.01 * exact);
  EXPECT_NEAR(wall["lbmMean_Pa"], exact, 0.01 * exact);
  EXPECT_LT(wall["relativeL2"], 0.03);
  EXPECT_NEAR(json["pressureDropDifference"], 0.0, 0.03);
  EXPECT_LT(json["velocity"]["axis"]["relativeL2"], 0.03);
  EXPECT_EQ(json["velocity"]["planes"].size(), 5u);
  EXPECT_GT(json["foam"]["seconds"], 0.0);
  EXPECT_GT(json["lbm"]["seconds"], 0.0);
  EXPECT_EQ(json["wss"]["unknownFaces"], 0);
  EXPECT_TRUE(exists("out/compare.vtp"));
  EXPECT_TRUE(exists("out/foam/case.foam"));
  EXPECT_TRUE(exists("out/compareVelocity.csv"));
}

TEST_F(Compare, IsRefusedInAFolderThatARunWritesInto) {
  RESTENOSIS_NEEDS_OPENFOAM();
  const std::string straight = scene("straight", straightTube);
  ASSERT_EXIT_STATUS(run({"run", straight, "-o", "done", "--flow", "analytic"}), 0);
  const auto writing = ResultsFolder::fresh(folder / "out"), going = ResultsFolder::existing(folder / "done");
  for (const std::vector<std::string>& command : {std::vector<std::string>{"compare", straight, "-o", "out"},
                                                  {"compare", "done"},
                                                  {"tradeoff", straight, "-o", "out"}}) {
    const ProcessEnd end = run(command);
    EXPECT_EXIT_STATUS(end, 2);
    EXPECT_NE(end.err.find("another run (process "), std::string::npos) << end.err;
  }
}

TEST_F(Compare, SaysBeforeAnythingElseThatOpenFoamIsMissing) {
  const ProcessEnd end =
      run({"compare", scene("tiny", tinyFoamScene()), "-o", "out"}, {{"PATH", "/nonexistent"}});
  EXPECT_EXIT_STATUS(end, 1);
  EXPECT_NE(end.err.find("apt install openfoam"), std::string::npos) << end.err;
  EXPECT_EQ(end.err.find("packing"), std::string::npos) << end.err;
  EXPECT_FALSE(exists("out"));
}

TEST_F(Compare, TakesTheLumenOfARun) {
  RESTENOSIS_NEEDS_OPENFOAM();
  const std::string straight = scene("straight", straightTube);
  ASSERT_EXIT_STATUS(run({"run", straight, "-o", "done", "--flow", "analytic"}), 0);
  ASSERT_EXIT_STATUS(run({"compare", "done", "--day", "0"}), 0);
  const auto json = nlohmann::json::parse(readText(folder / "done/compare/compare.json"));
  EXPECT_EQ(json["scene"], "done");
  EXPECT_EQ(json["day"], 0.0);

  // What a comparison that fails has found is not what the former one has
  EXPECT_EXIT_STATUS(run({"compare", "done", "--set", "lbm.maximumSteps=50"}), 1);
  EXPECT_FALSE(exists("done/compare/compare.json"));
}

/// As lumen.vtp of a run has it, whatever way the lumen points.
TEST_F(Compare, WhatComesOutLiesWhereTheLumenDoes) {
  RESTENOSIS_NEEDS_OPENFOAM();
  const SurfaceRegion open[] = {SurfaceRegion::wall};
  const auto motion = support::motionTo(Vec3(1, 2, 2), Vec3(3e-3, -2e-3, 1e-3));
  writeStl(folder / "oblique.stl", support::moved(support::tube(0.9e-3, 0.6e-3), motion), 1e-3, open);
  const std::string oblique =
      scene("oblique", with(with(straightTube, "length = \"0.6 mm\"\nlumenDiameter = \"1.8 mm\"",
                                 "lumenSurface = \"oblique.stl\""),
                            "pictures = false", "pictures = true"));
  ASSERT_EXIT_STATUS(run({"compare", oblique, "-o", "out"}), 0);

  const auto reader = vtkSmartPointer<vtkXMLPolyDataReader>::New();
  reader->SetFileName((folder / "out/compare.vtp").c_str());
  reader->Update();
  vtkPolyData* const surface = reader->GetOutput();
  ASSERT_GT(surface->GetNumberOfCells(), 0);
  vtkDataArray* const traction = surface->GetCellData()->GetArray("traction_lbm");
  for (vtkIdType t = 0; t < surface->GetNumberOfCells(); ++t) {
    Vec3 along, place;
    traction->GetTuple(t, along.data());
    surface->GetPoint(surface->GetCell(t)->GetPointId(0), place.data());
    EXPECT_NEAR((motion.inverse() * place).head<2>().norm(), 0.9e-3, 2e-6);
    EXPECT_GT(along.normalized().dot(motion.linear() * Vec3::UnitZ()), 0.99);
  }
  std::istringstream rows(readText(folder / "out/compareVelocity.csv"));
  std::string where;
  std::getline(rows, where);
  ASSERT_TRUE(std::getline(rows, where, ','));
  EXPECT_EQ(where, "axis");
  Vec3 place, velocity[2];
  char comma = 0;
  for (Vec3* v : {&place, &velocity[0], &velocity[1]})
    for (double& number : *v) rows >> number >> comma;
  EXPECT_LT((motion.inverse() * Vec3(1e-3 * place)).head<2>().norm(), 2e-6);
  for (const Vec3& u : velocity) EXPECT_GT(u.normalized().dot(motion.linear() * Vec3::UnitZ()), 0.99);

  const auto json = nlohmann::json::parse(readText(folder / "out/compare.json"));
  EXPECT_EQ(json["scene"], "oblique");
  EXPECT_NEAR(json["alongZ"]["rotation"][2][1], 2.0 / 3.0, 1e-3);
}

TEST_F(Compare, VelocitiesAreWrittenWhereTheyAreAskedFor) {
  RESTENOSIS_NEEDS_OPENFOAM();
  writeText(folder / "points.csv", "x_mm,y_mm,z_mm\n0,0,0.3\n0.45,0,0.3\n");
  ASSERT_EXIT_STATUS(run({"compare", scene("straight", straightTube), "-o", "out", "--probes", "points.csv"}),
                     0);
  std::istringstream rows(readText(folder / "out/compareVelocity.csv"));
  std::vector<double> foam, lattice;
  for (std::string line; std::getline(rows, line);) {
    if (!line.starts_with("probe,")) continue;
    std::vector<double> numbers;
    std::istringstream cells(line.substr(6));
    for (std::string cell; std::getline(cells, cell, ',');) numbers.push_back(std::stod(cell));
    ASSERT_EQ(numbers.size(), 9u);
    foam.push_back(numbers[5]), lattice.push_back(numbers[8]);
  }
  ASSERT_EQ(foam.size(), 2u);
  for (const auto& axial : {foam, lattice}) {
    EXPECT_NEAR(axial[0], 2 * 0.133, 0.01);
    EXPECT_NEAR(axial[1], 1.5 * 0.133, 0.01);
  }
  writeText(folder / "points.csv", "0,0,0.3\n");
  const auto end = run({"compare", scene("straight", straightTube), "-o", "wrong", "--probes", "points.csv"});
  EXPECT_EXIT_STATUS(end, 2);
  EXPECT_NE(end.err.find("points.csv:1"), std::string::npos) << end.err;
  EXPECT_FALSE(exists("wrong"));
}

TEST_F(Compare, BothMethodsAgreeInABentLumen) {
  const SurfaceRegion open[] = {SurfaceRegion::wall};
  const auto motion = support::motionTo(Vec3(1, 2, 2), Vec3(1e-3, 0, 2e-3));
  writeStl(folder / "bent.stl", support::moved(support::bentTube(0.5e-3, 0.6e-3, 1e-3, 0.4e-3), motion), 1e-3,
           open);
  const std::string bent =
      scene("bent", with(with(straightTube, "length = \"0.6 mm\"\nlumenDiameter = \"1.8 mm\"",
                              "lumenSurface = \"bent.stl\""),
                         "pictures = false", "pictures = true"));
  ASSERT_EXIT_STATUS(run({"compare", bent, "-o", "out", "--set", "lbm.dx=40 um"}), 0);
  const auto json = nlohmann::json::parse(readText(folder / "out/compare.json"));
  EXPECT_TRUE(json["bent"]);
  EXPECT_LT(std::abs(json["wss"]["smoothWall"]["meanDifference"].get<double>()), 0.02);
  EXPECT_LT(json["wss"]["smoothWall"]["relativeL2"], 0.08);
  EXPECT_LT(std::abs(json["pressureDropDifference"].get<double>()), 0.03);
  EXPECT_FALSE(json.contains("velocity")) << "its sections are not planes of constant z";
  EXPECT_TRUE(exists("out/compareScatter.png"));
  EXPECT_FALSE(exists("out/compareMaps.png"));
}

TEST_F(Compare, DamagedResultsAreRefusedBeforeAnythingIsWritten) {
  ASSERT_EXIT_STATUS(run({"run", scene("straight", straightTube), "-o", "done", "--flow", "analytic"}), 0);
  writeText(folder / "done/lumen.pvd", "<DataSet timestep=\"x\" file=\"lumen/a.vtp\"/>");
  for (const bool there : {true, false}) {
    if (!there) std::filesystem::remove(folder / "done/lumen.pvd");
    const auto end = run({"compare", "done"});
    EXPECT_EXIT_STATUS(end, 2);
    EXPECT_NE(toString(end).find("lumen.pvd"), std::string::npos) << toString(end);
    EXPECT_FALSE(exists("done/compare"));
  }
}

TEST_F(Compare, WrongInputIsNamed) {
  std::string text = straightTube;
  text.replace(text.find("[flow]"), text.find("[lbm]") - text.find("[flow]"), "");
  auto end = run({"compare", scene("dry", text)});
  EXPECT_EXIT_STATUS(end, 2);
  EXPECT_NE(toString(end).find("[flow]"), std::string::npos);
  end = run({"compare", scene("straight", straightTube), "--day", "3"});
  EXPECT_EXIT_STATUS(end, 2);
  EXPECT_NE(toString(end).find("--day"), std::string::npos);
  EXPECT_EXIT_STATUS(run({"compare", "missing.toml"}), 2);
}

TEST_F(Compare, ChangesOfAFinishedRunsLumenAreRefused) {
  ASSERT_EXIT_STATUS(run({"run", scene("straight", straightTube), "-o", "done", "--flow", "analytic"}), 0);
  for (const char* change :
       {"vessel.length=1 mm", "scene.seed=2", "stent=present", "flowing.drive=flowRate"}) {
    const auto end = run({"compare", "done", "--set", change});
    EXPECT_EXIT_STATUS(end, 2);
    EXPECT_NE(toString(end).find(change), std::string::npos) << toString(end);
    EXPECT_NE(toString(end).find("scene.fidelity"), std::string::npos) << toString(end);
  }
  EXPECT_FALSE(exists("done/compare"));
}

}  // namespace
}  // namespace restenosis

#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkXMLPolyDataReader.h>

#include <array>
#include <cmath>
#include <vector>

#include "tests/support/WholeProgram.h"
#include "tissue/equilibrium/RelaxationParameters.h"

namespace restenosis {
namespace {

/// A cell of tissue.pvd.
struct RecordedCell {
  double id, generation, radius;
  std::array<double, 3> centre;
};

std::vector<RecordedCell> readCells(const std::filesystem::path& file) {
  const auto reader = vtkSmartPointer<vtkXMLPolyDataReader>::New();
  reader->SetFileName(file.c_str());
  reader->Update();
  vtkPolyData* const agents = reader->GetOutput();
  const auto array = [&](const char* name) { return agents->GetPointData()->GetArray(name); };
  std::vector<RecordedCell> cells;
  for (vtkIdType n = 0; n < agents->GetNumberOfPoints(); ++n) {
    if (array("kind")->GetTuple1(n) != 0) continue;
    cells.push_back(
        {array("id")->GetTuple1(n), array("generation")->GetTuple1(n), array("radius")->GetTuple1(n), {}});
    agents->GetPoint(n, cells.back().centre.data());
  }
  return cells;
}

/// Whether some other cell is nearer than 0.6 times the sum of both radii.
bool isHalfOfADoublet(const RecordedCell& cell, const std::vector<RecordedCell>& cells) {
  return std::ranges::any_of(cells, [&](const RecordedCell& other) {
    return other.id != cell.id &&
           std::hypot(other.centre[0] - cell.centre[0], other.centre[1] - cell.centre[1],
                      other.centre[2] - cell.centre[2]) < 0.6 * (other.radius + cell.radius);
  });
}

using Growth = WholeProgram;

TEST_F(Growth, LeavesNoDoublets) {
  // Daughters are born overlapping; a day later they have made room for themselves.
  ASSERT_EXIT_STATUS(
      run({"run", scene("tiny", tinyScene), "-o", "out", "--flow", "none", "--set", "scene.duration=10 d"}),
      0);
  const auto before = readCells(folder / "out/tissue/tissue_000108.vtp");  // day 9
  const auto after = readCells(folder / "out/tissue/tissue_000120.vtp");
  std::map<double, double> generationBefore;
  for (const RecordedCell& cell : before) generationBefore[cell.id] = cell.generation;
  int daughters = 0, doublets = 0;
  for (const RecordedCell& cell : after) {
    const auto earlier = generationBefore.find(cell.id);
    const bool dividedLately = earlier == generationBefore.end() || earlier->second != cell.generation;
    if (dividedLately || cell.generation == 0) continue;
    ++daughters;
    doublets += isHalfOfADoublet(cell, after);
  }
  EXPECT_GT(daughters, 200) << "too few for the share below to mean anything";
  EXPECT_LT(doublets, 0.005 * daughters);
}

TEST_F(Growth, TakesTheLumenOnlyWhereItIsRead) {
  ASSERT_EXIT_STATUS(run({"run", scene("tiny", tinyScene), "-o", "out", "--flow", "none"}), 0);
  const auto json = summary("out");
  // Nine recorded states, of each the lumen and its surface.
  EXPECT_LE(json["parts"]["surface"]["calls"], 18);
  EXPECT_GT(json["relaxation"]["iterations"], 0);
  EXPECT_GT(json["relaxation"]["agentEvaluations"], json["relaxation"]["iterations"]);
  EXPECT_GT(json["relaxation"]["largestResidual"], 0);
  EXPECT_LE(json["relaxation"]["largestResidual"], RelaxationParameters().tolerance);

  // What is recorded, and when, changes nothing that grows.
  ASSERT_EXIT_STATUS(run({"run", scene("tiny", tinyScene), "-o", "seldom", "--flow", "none", "--set",
                          "output.interval=2 d"}),
                     0);
  EXPECT_EQ(digest("seldom"), digest("out"));
}

}  // namespace
}  // namespace restenosis

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include "tests/support/OpenFoamPresent.h"
#include "tests/support/WholeProgram.h"

namespace restenosis {
namespace {

using namespace std::chrono_literals;

class BeatingRun : public WholeProgram {
 protected:
  /// A tube of coarse cells, and a beat of few steps by a table of its own.
  std::string tube(const std::string& more = "") {
    writeText(folder / "beat.csv", "time,flowRate\n0,50\n0.2,20\n0.5,80\n0.8,50\n");
    return scene("tube", R"([scene]
title = "Tube"
duration = "1 h"
step = "1 h"
fidelity = "draft"
[vessel]
length = "1.2 mm"
lumenDiameter = "1.8 mm"
[foam]
cellSize = "150 um"
beatSteps = 20
[flow]
backend = "foam"
meanVelocity = "0.133 m/s"
waveformFile = "beat.csv"
beats = 2
)" + more);
  }
};

TEST_F(BeatingRun, LeavesTheStressOverABeat) {
  RESTENOSIS_NEEDS_OPENFOAM();
  ASSERT_EXIT_STATUS(run({"run", tube(), "-o", "out"}), 0);
  const auto beats = summary("out")["flow"]["beats"];
  EXPECT_EQ(beats["beats"], 2);
  EXPECT_NEAR(beats["period_s"], 0.8, 1e-12);
  EXPECT_NEAR(beats["steadyMeanDifference"], 0, 0.02);  // the flow never turns
  EXPECT_TRUE(exists("out/beats.png"));
  EXPECT_TRUE(exists("out/flow/0/beats/case.foam"));

  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName((folder / "out/lumen/lumen_000000.vtp").c_str());
  reader->Update();
  vtkCellData* cells = reader->GetOutput()->GetCellData();
  for (const char* name : {"TAWSS", "OSI", "RRT", "transWSS"})
    ASSERT_NE(cells->GetArray(name), nullptr) << name;
  EXPECT_EQ(cells->GetArray("WSS")->GetTuple1(0), cells->GetArray("TAWSS")->GetTuple1(0));
  EXPECT_LT(cells->GetArray("OSI")->GetRange()[1], 0.01);

  // The case runs by hand, too
  const ProcessEnd byHand = Process({(folder / "out/flow/0/Allrun").string()}, folder.path()).wait(5min);
  EXPECT_EXIT_STATUS(byHand, 0);
  EXPECT_TRUE(exists("out/flow/0/beats/postProcessing/samples/wall/points"));
}

TEST_F(BeatingRun, MayFeelTheSteadyStress) {
  RESTENOSIS_NEEDS_OPENFOAM();
  ASSERT_EXIT_STATUS(
      run({"run", tube("stressMeasure = \"steady\"\n[output]\npictures = false\n"), "-o", "beating"}), 0);
  ASSERT_EXIT_STATUS(
      run({"run", tube(), "-o", "steady", "--set", "flow.waveformFile=", "--set", "output.pictures=false"}),
      0);
  EXPECT_EQ(summary("beating")["final"]["wssMean_Pa"], summary("steady")["final"]["wssMean_Pa"]);
  EXPECT_TRUE(summary("steady")["flow"]["beats"].is_null());
  EXPECT_FALSE(exists("steady/flow/0/beats"));
}

TEST_F(BeatingRun, OfATableThatIsNoneIsRefused) {
  const std::string scene = tube();
  writeText(folder / "beat.csv", "time,flowRate\n0,50\n0.2,20\n0.1,80\n0.8,50\n");
  const ProcessEnd end = run({"run", scene, "-o", "out"});
  EXPECT_EXIT_STATUS(end, 2);
  EXPECT_NE(end.err.find("beat.csv:4: the time 0.1 s does not come after 0.2 s"), std::string::npos)
      << end.err;
  EXPECT_FALSE(exists("out"));
}

}  // namespace
}  // namespace restenosis

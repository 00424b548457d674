#include "OpenFoamPresent.h"
#include "WholeProgram.h"

namespace restenosis {
namespace {

using FoamRun = WholeProgram;

/// The whole loop with OpenFOAM. The run begins where OpenFOAM is missing and goes on once it is there, as
/// that of a user who reads the message and installs it.
TEST_F(FoamRun, GrowsWithSeveralSolvesAndLoadsInParaView) {
  RESTENOSIS_NEEDS_OPENFOAM();
  const std::string text = with(tinyFoamScene(), "\"4 d\"", "\"90 h\"");
  const std::string tiny =
      scene("tiny", text + "keepFlowCases = \"all\"\n[coupling]\nlumenTolerance = \"3 um\"\n");
  EXPECT_EXIT_STATUS(run({"run", tiny, "-o", "out"}, {{"PATH", "/nonexistent"}}), 1);
  ASSERT_EXIT_STATUS(run({"run", tiny, "-o", "out", "--resume"}), 0);

  const auto json = summary("out");
  const int solves = json["flow"]["solvesDone"];
  EXPECT_GE(solves, 2);
  EXPECT_GT(json["parts"]["mesh"]["seconds"], 0.0);
  EXPECT_GT(json["final"]["wssMean_Pa"], 0.0);
  int cases = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "out/flow"))
    cases += std::filesystem::exists(entry.path() / "case.foam");
  EXPECT_EQ(cases, solves);

  // Poiseuille from the local radius is a rough guide to so short and rough a tube, whose bumps lie in each
  // other's lee: with seven seeds the mean is 0.61 to 0.81 of it, and the lattice agrees with OpenFOAM.
  ASSERT_EXIT_STATUS(run({"run", tiny, "-o", "analytic", "--flow", "analytic"}), 0);
  const double analytic = summary("analytic")["final"]["wssMean_Pa"];
  EXPECT_NEAR(json["final"]["wssMean_Pa"], analytic, 0.5 * analytic);

  if (std::system("command -v pvpython >/dev/null") != 0) {
    std::cout << "ParaView (pvpython) is not installed: loading is not tested\n";
    return;
  }
  const std::string script = std::string(RESTENOSIS_SOURCE_DIR) + "/tests/regression/loadInParaView.py";
  const ProcessEnd loaded =
      Process({"/usr/bin/env", "pvpython", script, "out"}, folder.path()).wait(patience);
  EXPECT_EXIT_STATUS(loaded, 0);
}

}  // namespace
}  // namespace restenosis

#include "tests/support/OpenFoamPresent.h"
#include "tests/support/WholeProgram.h"

namespace restenosis {
namespace {

using FoamRun = WholeProgram;

/// The whole loop with OpenFOAM. The run begins where OpenFOAM is missing and goes on once it is there, as
/// that of a user who reads the message and installs it.
TEST_F(FoamRun, GrowsWithSeveralSolvesAndLoadsInParaView) {
  RESTENOSIS_NEEDS_OPENFOAM();
  const std::string text = with(tinyFoamScene(), "\"4 d\"", "\"90 h\"");
  const std::string tiny =
      scene("tiny", with(text, "lumenTolerance = \"5 um\"", "lumenTolerance = \"3 um\"") +
                        "keepFlowCases = \"all\"\n");
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

  // In the last lumen, which is short and rough, the lattice finds the same: Poiseuille from the local radius
  // would be no guide, as bumps lie in each other's lee.
  ASSERT_EXIT_STATUS(run({"compare", "out", "-o", "compared"}), 0);
  const auto compared = nlohmann::json::parse(readText(folder / "compared/compare.json"));
  EXPECT_NEAR(compared["pressureDropDifference"], 0, 0.02);
  for (const char* part : {"strut", "ends"}) {
    EXPECT_GT(compared["wss"][part]["count"], 100) << part;
    EXPECT_NEAR(compared["wss"][part]["meanDifference"], 0, 0.1) << part;
  }
  const double lattice = compared["wss"]["ends"]["lbmMean_Pa"];
  EXPECT_NEAR(json["final"]["wssMean_Pa"], lattice, 0.1 * lattice);

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

#include "tests/support/WholeProgram.h"

namespace restenosis {
namespace {

class CrossChecked : public WholeProgram {
 protected:
  /// A lattice fine enough for so narrow a lumen, beside the flow of the tiny scene.
  ProcessEnd runChecked(const std::string& out, std::vector<std::string> more = {}) const {
    std::vector<std::string> arguments = {"run",   scene("tiny", tinyScene),  "-o", out,
                                          "--set", "scene.fidelity=reference"};
    std::ranges::move(more, std::back_inserter(arguments));
    return run(arguments);
  }
  static std::vector<std::string> byLattice() { return {"--set", "flow.crossCheck=lbm"}; }
};

TEST_F(CrossChecked, TheStateIsThatOfARunWithout) {
  ASSERT_EXIT_STATUS(runChecked("without"), 0);
  ASSERT_EXIT_STATUS(runChecked("with", byLattice()), 0);
  EXPECT_EQ(digest("with"), digest("without"));
  EXPECT_EQ(summary("with")["sceneFingerprint"], summary("without")["sceneFingerprint"]);
  EXPECT_TRUE(summary("without")["crossCheck"].is_null());
}

TEST_F(CrossChecked, TheFirstAndTheLastSolveAreCheckedWhateverTheShare) {
  auto options = byLattice();
  options.insert(options.end(), {"--set", "flow.crossCheckShare=0"});
  ASSERT_EXIT_STATUS(runChecked("out", options), 0);
  const auto check = summary("out")["crossCheck"];
  EXPECT_EQ(check["method"], "lbm");
  EXPECT_EQ(check["checks"], 2);
  EXPECT_EQ(check["failed"], 0);
  EXPECT_GT(check["seconds"], 0);
  EXPECT_LT(std::abs(check["struts"]["meanDifference"][0].get<double>()), 1);
  const CsvColumns days(folder.path() / "out" / "timeSeries.csv");
  std::vector<std::size_t> checked;
  for (std::size_t n = 0; n < days.rows(); ++n)
    if (days.values.at("crossCheckStrutsMean")[n]) checked.push_back(n);
  ASSERT_EQ(checked.size(), 2u);
  EXPECT_EQ(checked.back(), days.rows() - 1);
  EXPECT_TRUE(days.values.at("crossCheckDecidedOtherwise").back());
  EXPECT_TRUE(exists("out/crossCheck"));
}

TEST_F(CrossChecked, EverySolveIsCheckedWhereTimeAllows) {
  auto options = byLattice();
  options.insert(options.end(), {"--set", "flow.crossCheckShare=10", "--set", "scene.duration=84 h"});
  // An analytic flow takes no time, so that its share pays for the first and the last only
  ASSERT_EXIT_STATUS(runChecked("analytic", options), 0);
  EXPECT_EQ(summary("analytic")["crossCheck"]["checks"], 2);
  options.insert(options.end(), {"--set", "flow.crossCheck=reference", "--flow", "lbm", "--set",
                                 "scene.fidelity=standard", "--set", "lbm.dx=20 um"});
  ASSERT_EXIT_STATUS(runChecked("lattice", options), 0);
  const auto lattice = summary("lattice");
  EXPECT_GT(lattice["flow"]["solvesDone"], 2);
  EXPECT_EQ(lattice["crossCheck"]["checks"], lattice["flow"]["solvesDone"]);
}

TEST_F(CrossChecked, AResumedRunChecksItsLastSolve) {
  ASSERT_EXIT_STATUS(runChecked("reference"), 0);
  auto options = byLattice();
  options.insert(options.end(), {"--set", "flow.crossCheckShare=0", "--set", "scene.duration=84 h"});
  ASSERT_EXIT_STATUS(runChecked("out", options), 0);
  options.back() = "scene.duration=4 d";
  options.emplace_back("--resume");
  ASSERT_EXIT_STATUS(runChecked("out", options), 0);
  EXPECT_EQ(digest("out"), digest("reference"));
  // A finished run goes on from before its last step, so that what was the last solve then is not checked
  // again
  EXPECT_EQ(summary("out")["crossCheck"]["checks"], 2);
  const CsvColumns days(folder.path() / "out" / "timeSeries.csv");
  EXPECT_TRUE(days.values.at("crossCheckStrutsMean").back());
}

TEST_F(CrossChecked, AFailedCheckIsARemarkAndNotTheRunsEnd) {
  auto options = byLattice();
  options.insert(options.end(), {"--set", "lbm.maximumNodes=1000"});
  ASSERT_EXIT_STATUS(runChecked("out", options), 0);
  const auto found = summary("out");
  EXPECT_EQ(found["status"], "finished");
  EXPECT_GE(found["crossCheck"]["failed"], 2);
  EXPECT_EQ(found["crossCheck"]["checks"], 0);
  EXPECT_TRUE(found["crossCheck"]["smoothWall"]["meanDifference"].is_null());
  EXPECT_NE(found["remarks"].dump().find("cross-check at day"), std::string::npos) << found["remarks"];
}

TEST_F(CrossChecked, ALargeDifferenceIsSaid) {
  auto options = byLattice();
  options.insert(options.end(), {"--set", "flow.crossCheckLimit=0"});
  const ProcessEnd end = runChecked("out", options);
  ASSERT_EXIT_STATUS(end, 0);
  EXPECT_NE((end.out + end.err).find("the mean stress by lbm differs by"), std::string::npos)
      << toString(end);
  EXPECT_NE(summary("out")["remarks"].dump().find("on struts (flow.crossCheckLimit: 0 %)"),
            std::string::npos);
}

TEST_F(CrossChecked, ACheckByTheVerySameMethodIsRefused) {
  for (const auto& options :
       std::vector<std::vector<std::string>>{{"--flow", "lbm", "--set", "flow.crossCheck=lbm"},
                                             {"--set", "flow.crossCheck=reference"},
                                             {"--flow", "lbm", "--set", "flow.crossCheck=reference"},
                                             {"--set", "flow.crossCheck=openfoam"},
                                             {"--set", "flow.crossCheckShare=-1"}}) {
    const ProcessEnd end = runChecked("out", options);
    EXPECT_EXIT_STATUS(end, 2);
    EXPECT_NE(end.err.find("crossCheck"), std::string::npos) << toString(end);
    EXPECT_FALSE(exists("out"));
  }
}

}  // namespace
}  // namespace restenosis

#include <fmt/format.h>

#include "tests/support/OpenFoamPresent.h"
#include "tests/support/WholeProgram.h"

namespace restenosis {
namespace {

using NarrowedLumen = WholeProgram;

std::string latticeScene(const char* dx) {
  return with(tinyScene, "\"analytic\"", "\"lbm\"") + fmt::format("\n[lbm]\ndx = \"{}\"\n", dx);
}

/// A scene in which nothing holds tissue back from closing the lumen.
std::string closing(std::string text) {
  const auto stent = text.find("[stent]"), injury = text.find("[injury]");
  text.erase(stent, injury - stent);
  text = with(with(text, "[contactInhibition]\n", ""), "cellRadius", "fixedEnds = 0\ncellRadius");
  text = with(text, "[coupling]\n", "[coupling]\nschedule = \"everyStep\"\n");
  return with(text, "[flow]\n", "[flow]\nmeanVelocity = \"1 mm/s\"\n");
}

/// What is asked of the lumen as the scene gives it, although deployment widens it.
TEST_F(NarrowedLumen, OneThatIsTooNarrowFromTheFirstIsRefusedAtTheFirstSolve) {
  const ProcessEnd end = run({"run", scene("coarse", latticeScene("60 um")), "-o", "out"});
  EXPECT_EXIT_STATUS(end, 1);
  EXPECT_NE(
      end.err.find("'dx' in [lbm] is 60 um: a lumen of 0.4 mm has 6.7 nodes across, at least 8 are needed"),
      std::string::npos)
      << end.err;
}

TEST_F(NarrowedLumen, OneThatTissueClosesIsSolvedInToTheEnd) {
  const std::string file = scene("closing", closing(latticeScene("48 um")));  // 8.3 nodes across
  ASSERT_EXIT_STATUS(run({"run", file, "-o", "out"}), 0);
  const auto json = summary("out");
  EXPECT_EQ(json["status"], "occluded");
  std::vector<std::string> narrow;
  for (const std::string remark : json["remarks"])
    if (remark.find("with less than 6") != std::string::npos) narrow.push_back(remark);
  ASSERT_EQ(narrow.size(), 4u) << "the first three and the last";
  EXPECT_NE(narrow.back().find("(the last of "), std::string::npos) << narrow.back();
}

/// minimumCellsAcross is asked of the lumen before the run only.
TEST_F(NarrowedLumen, OneThatTissueClosesIsSolvedInToTheEndByOpenFoam) {
  RESTENOSIS_NEEDS_OPENFOAM();
  const std::string text = with(with(tinyScene, "\"analytic\"", "\"foam\""), "2 h", "6 h") +
                           "\n[foam]\ncellSize = \"22.5 um\"\nminimumCellsAcross = 16\n";  // 17.8 across
  ASSERT_EXIT_STATUS(run({"run", scene("closing", closing(text)), "-o", "out"}), 0);
  EXPECT_EQ(summary("out")["status"], "occluded");
}

}  // namespace
}  // namespace restenosis

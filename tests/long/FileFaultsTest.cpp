// A full disk or a crash at any write of a run, and amid the case of an OpenFOAM solve.
#include "tests/support/FileFaults.h"
#include "tests/support/OpenFoamPresent.h"

namespace restenosis {
namespace {

class EveryFault : public FileFaults, public ::testing::WithParamInterface<const char*> {};

TEST_P(EveryFault, LeavesARunThatEndsAsTheWholeOne) {
  scene("short", shortScene);
  expectEveryFaultMended(GetParam());
}

INSTANTIATE_TEST_SUITE_P(kinds, EveryFault, ::testing::Values("fail", "torn", "kill"),
                         [](const auto& test) { return std::string(test.param); });

class FoamFileFaults : public FileFaults, public ::testing::WithParamInterface<const char*> {};

/// Three solves, each from the case of the one before.
TEST_P(FoamFileFaults, LeaveARunThatEndsAsTheWholeOne) {
  RESTENOSIS_NEEDS_OPENFOAM();
  scene("short", with(with(with(shortScene, "\"analytic\"", "\"foam\""), "6 h", "4 h"), "[output]",
                      "[foam]\ncellSize = \"18 um\"\nwallLevel = 0\nstrutLevel = 1\n"
                      "[coupling]\nlumenTolerance = \"0.02 um\"\n[output]"));
  expectEveryFaultMended(GetParam(), 13);
}

INSTANTIATE_TEST_SUITE_P(kinds, FoamFileFaults, ::testing::Values("fail", "kill"),
                         [](const auto& test) { return std::string(test.param); });

}  // namespace
}  // namespace restenosis

#include <gtest/gtest.h>

#include <cstdlib>

#include "FoamRequirements.h"
#include "TemporaryFolder.h"

namespace restenosis {
namespace {

TEST(FoamRequirements, NameWhatAPathMayNotHold) {
  EXPECT_EQ(unusableFoamPath("/results/quick-2(a)"), "");
  EXPECT_EQ(unusableFoamPath("/my results/quick"),
            "/my results/quick: OpenFOAM works in no folder with a blank in its path");
  EXPECT_EQ(unusableFoamPath("/it's"), "/it's: OpenFOAM works in no folder with the character ' in its path");
}

TEST(FoamRequirements, NameTheProgramThatIsMissingAndItsPackage) {
  TemporaryFolder empty;
  const std::string former = std::getenv("PATH");
  setenv("PATH", empty.path().c_str(), 1);
  const std::string missing = missingFoamProgram(1);
  setenv("PATH", former.c_str(), 1);
  EXPECT_NE(missing.find("'blockMesh' is not on the PATH"), std::string::npos) << missing;
  EXPECT_NE(missing.find("apt install openfoam"), std::string::npos) << missing;
  EXPECT_NE(missingProgramText("mpirun").find("openmpi-bin"), std::string::npos);
}

}  // namespace
}  // namespace restenosis

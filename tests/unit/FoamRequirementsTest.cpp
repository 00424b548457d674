#include <gtest/gtest.h>

#include <cstdlib>

#include "bridge/flow/foam/FoamRequirements.h"
#include "tests/support/TemporaryFolder.h"

namespace restenosis {
namespace {

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

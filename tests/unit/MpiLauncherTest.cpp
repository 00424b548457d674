#include <gtest/gtest.h>

#include "bridge/flow/foam/FoamRequirements.h"
#include "bridge/flow/foam/MpiLauncher.h"
#include "tests/support/EnvironmentVariable.h"

namespace restenosis {
namespace {

using Words = std::vector<std::string>;

TEST(MpiLauncher, IsMpirunWhereNothingElseIsSaid) {
  const EnvironmentVariable none(launcherVariable, nullptr);
  EXPECT_EQ(mpiLauncher(), Words({"mpirun"}));
}

TEST(MpiLauncher, IsMpirunWhereNoWordIsSaid) {
  const EnvironmentVariable blank(launcherVariable, "  ");
  EXPECT_EQ(mpiLauncher(), Words({"mpirun"}));
}

TEST(MpiLauncher, HasTheWordsThatBlanksPart) {
  const EnvironmentVariable srun(launcherVariable, " srun --mpi=pmix  -N 2 ");
  EXPECT_EQ(mpiLauncher(), Words({"srun", "--mpi=pmix", "-N", "2"}));
}

TEST(MpiLauncher, IsNamedWhereItIsMissing) {
  const EnvironmentVariable other(launcherVariable, "nosuchstarter -x");
  EXPECT_NE(missingProgramText("nosuchstarter").find("'nosuchstarter', which is to start"),
            std::string::npos);
}

}  // namespace
}  // namespace restenosis

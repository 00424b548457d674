#include <fmt/format.h>

#include "tests/support/WholeProgram.h"

namespace restenosis {
namespace {

/// The environment of the program that draws pictures, one that a run starts at its end.
class RuntimeSettings : public WholeProgram {
 protected:
  std::string environmentOfPrograms(Environment environment) {
    const std::filesystem::path python = folder / "python";
    const std::filesystem::path seen = folder / "environment";
    writeText(python, fmt::format("#!/bin/sh\n{{ env; echo \"parent=$(cat /proc/$PPID/comm)\"; }} > '{}'\n",
                                  seen.string()));
    std::filesystem::permissions(python, std::filesystem::perms::owner_all);
    environment["RESTENOSIS_PYTHON"] = python.string();
    const std::string tiny = scene("tiny", tinyScene);
    EXPECT_EXIT_STATUS(run({"run", tiny, "-o", "results", "--flow", "none", "--set", "scene.duration=1 d",
                            "--set", "output.pictures=true", "--set", "output.interval=1 d"},
                           environment),
                       0);
    return '\n' + readText(seen);
  }
};

TEST_F(RuntimeSettings, AreNotThoseOfProgramsThatItStarts) {
  const std::string environment = environmentOfPrograms({});
  EXPECT_EQ(environment.find("\nGLIBC_TUNABLES="), std::string::npos) << environment;
  EXPECT_EQ(environment.find("\nRESTENOSIS_STARTED_AGAIN="), std::string::npos) << environment;
}

TEST_F(RuntimeSettings, LeaveTheProgramItsName) {
  EXPECT_NE(environmentOfPrograms({}).find("\nparent=restenosisFoam\n"), std::string::npos);
}

TEST_F(RuntimeSettings, LeaveTheUsersOwn) {
  const std::string environment =
      environmentOfPrograms({{"GLIBC_TUNABLES", "glibc.malloc.arena_max=3"}, {"OMP_WAIT_POLICY", "active"}});
  EXPECT_NE(environment.find("\nGLIBC_TUNABLES=glibc.malloc.arena_max=3\n"), std::string::npos)
      << environment;
  EXPECT_NE(environment.find("\nOMP_WAIT_POLICY=active\n"), std::string::npos) << environment;
}

}  // namespace
}  // namespace restenosis

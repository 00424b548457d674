#include <gtest/gtest.h>

#include "bridge/flow/foam/FoamEnvironment.h"
#include "tests/support/EnvironmentVariable.h"
#include "tests/support/TemporaryFolder.h"

namespace restenosis {
namespace {

namespace fs = std::filesystem;

/// What a program sees that OpenFOAM's environment is set for.
std::string seenIn(const fs::path& folder) {
  ExternalProgram program("printenv");
  setFoamEnvironment(program, folder);
  const TemporaryFolder logs;
  program.run({}, folder, logs / "log");
  return '\n' + readText(logs / "log");
}

TEST(FoamEnvironment, KeepsTheUsersSettingsOfOtherCasesOut) {
  const TemporaryFolder scratch;
  const EnvironmentVariable collated("FOAM_FILEHANDLER", "collated"), aborts("FOAM_ABORT", "true"),
      control("FOAM_CONTROLDICT", "DebugSwitches { fvMesh 1; }"), site("WM_PROJECT_SITE", "/site"),
      buffer("MPI_BUFFER_SIZE", "1"), ownPath("RF_PATH", "kept");
  const std::string seen = seenIn(scratch.path());
  EXPECT_NE(seen.find("\nFOAM_FILEHANDLER=uncollated\n"), std::string::npos) << seen;
  EXPECT_NE(seen.find("\nFOAM_SIGFPE=true\n"), std::string::npos) << seen;
  EXPECT_NE(seen.find("\nRF_PATH=kept\n"), std::string::npos) << seen;
  for (const char* other : {"FOAM_ABORT", "FOAM_CONTROLDICT", "WM_PROJECT_SITE", "MPI_BUFFER_SIZE"})
    EXPECT_EQ(seen.find(other), std::string::npos) << other;
}

TEST(FoamEnvironment, HasAHomeWithoutEtcFilesOfTheUser) {
  const TemporaryFolder scratch, home;
  const EnvironmentVariable users("HOME", home.path().c_str());
  EXPECT_EQ(seenIn(scratch.path()).find("\nHOME=" + home.path().string()), std::string::npos);
}

TEST(FoamEnvironment, KeepsVariablesOfAnMpiJobOutButTheUsersWithoutOne) {
  const TemporaryFolder scratch;
  const EnvironmentVariable size("OMPI_COMM_WORLD_SIZE", nullptr), pmix("PMIX_RANK", nullptr),
      pmi("PMI_RANK", nullptr);
  const EnvironmentVariable chosen("OMPI_MCA_btl_tcp_if_include", "lo"), space("PMIX_NAMESPACE", "1");
  EXPECT_NE(seenIn(scratch.path()).find("\nOMPI_MCA_btl_tcp_if_include=lo\n"), std::string::npos);
  const EnvironmentVariable within("PMIX_RANK", "0");
  const std::string seen = seenIn(scratch.path());
  EXPECT_EQ(seen.find("OMPI_MCA_btl_tcp_if_include"), std::string::npos);
  EXPECT_EQ(seen.find("PMIX_"), std::string::npos);
}

TEST(FoamEnvironment, NamesTheFolderAsOpenFoamCanReadIt) {
  const TemporaryFolder scratch;
  for (const char* plain :
       {"quick-2(a)", "dollar$HOME", "umlaut\xc3\xa4", "semicolon;", "#hash{}", "back\\slash"}) {
    fs::create_directory(scratch / plain);
    EXPECT_EQ(foamWorkingFolder(scratch / plain), (scratch / plain).string());
  }
  for (const char* odd : {"a b", "tab\t", "line\nline", "it's", "say \"x\""}) {
    fs::create_directory(scratch / odd);
    const std::string name = foamWorkingFolder(scratch / odd);
    EXPECT_EQ(name.find_first_of(" \t\n'\""), std::string::npos) << name;
    // Whatever its name, it is where the program is
    EXPECT_NE(seenIn(scratch / odd).find("\nPWD=" + name + "\n"), std::string::npos);
  }
}

TEST(FoamEnvironment, FindsOpenFoamWhereItIsInstalled) {
  const TemporaryFolder scratch;
  const auto project = scratch / "openfoam", none = scratch / "none", program = scratch / "bin/simpleFoam";
  fs::create_directories(project / "etc");
  writeText(project / "etc/controlDict", "");
  const bool packaged = fs::exists("/usr/share/openfoam/etc/controlDict");
  {
    const EnvironmentVariable users("WM_PROJECT_DIR", project.c_str());
    EXPECT_EQ(foamProjectFolder(program), project);
    if (packaged) {
      EXPECT_EQ(foamProjectFolder("/usr/bin/simpleFoam"), "/usr/share/openfoam");
    }
  }
  for (const char* empty : {static_cast<const char*>(nullptr), ""}) {
    const EnvironmentVariable users("WM_PROJECT_DIR", empty);
    EXPECT_EQ(foamProjectFolder(program), "/usr/share/openfoam");
  }
  const EnvironmentVariable stale("WM_PROJECT_DIR", none.c_str());
  if (packaged) {
    EXPECT_EQ(foamProjectFolder(program), "/usr/share/openfoam");
  } else {
    try {
      foamProjectFolder(program);
      FAIL();
    } catch (const std::runtime_error& error) {
      EXPECT_NE(std::string(error.what()).find("WM_PROJECT_DIR"), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find(none), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace restenosis

#include <gtest/gtest.h>

#include "bridge/system/DataFolder.h"
#include "tests/support/TemporaryFolder.h"

namespace restenosis {
namespace {

namespace fs = std::filesystem;

TEST(DataFolder, IsBesideTheFolderOfAnInstalledProgram) {
  const TemporaryFolder folder;
  fs::create_directories(folder / "usr/bin");
  EXPECT_EQ(dataFolder(folder / "usr/bin"), folder / "usr/share/restenosisFoam") << "where it should be";
  fs::create_directories(folder / "usr/share/restenosisFoam");
  EXPECT_EQ(dataFolder(folder / "usr/bin"), folder / "usr/share/restenosisFoam");
}

TEST(DataFolder, IsBelowThatOfAProgramInABuildTree) {
  const TemporaryFolder folder;
  fs::create_directories(folder / "release/share/restenosisFoam");
  EXPECT_EQ(dataFolder(folder / "release"), folder / "release/share/restenosisFoam");
}

TEST(DataFolder, OfThisProgramHoldsTemplateAndFigures) {
  for (const char* file : {"foamCase/system/lumenParameters", "figures/__main__.py", "scenes/quick.toml"})
    EXPECT_TRUE(fs::is_regular_file(dataFolder() / file)) << file;
}

}  // namespace
}  // namespace restenosis

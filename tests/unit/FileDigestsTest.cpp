#include <gtest/gtest.h>

#include <stdexcept>

#include "bridge/output/FileDigests.h"
#include "tests/support/TemporaryFolder.h"

namespace restenosis {
namespace {

TEST(FileDigests, NameTheFileThatIsMissingChangedOrNew) {
  TemporaryFolder folder;
  std::filesystem::create_directory(folder / "mesh");
  writeText(folder / "mesh/points", std::string(8192, 'p'));
  writeText(folder / "U", "velocity");
  const auto before = digestsOf(folder.path(), {"mesh/points", "U"});
  EXPECT_EQ(changeOfFiles(before, digestsOf(folder.path(), {"U", "mesh/points"})), "");
  writeText(folder / "mesh/points", std::string(4096, 'p') + std::string(4096, '\0'));
  EXPECT_EQ(changeOfFiles(before, digestsOf(folder.path(), {"mesh/points", "U"})),
            "where mesh/points has been changed");
  EXPECT_EQ(changeOfFiles(before, digestsOf(folder.path(), {"U"})), "where mesh/points is missing");
  EXPECT_EQ(changeOfFiles(digestsOf(folder.path(), {"U"}), digestsOf(folder.path(), {"mesh/points", "U"})),
            "where mesh/points has been added");
  EXPECT_THROW(digestsOf(folder.path(), {"p"}), std::runtime_error);
}

TEST(FileDigests, OfFilesThatAreGoneAreNoneToFlush) {
  TemporaryFolder folder;
  std::filesystem::create_directories(folder / "a/b/c");
  writeText(folder / "a/b/c/U", "velocity");
  EXPECT_NO_THROW(flushFiles(folder / "a/b", {{"c/U", ""}, {"c/p", ""}, {"d/p", ""}}));
}

}  // namespace
}  // namespace restenosis

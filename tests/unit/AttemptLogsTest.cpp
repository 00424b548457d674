#include <gtest/gtest.h>

#include "bridge/flow/foam/AttemptLogs.h"
#include "tests/support/TemporaryFolder.h"

namespace restenosis {
namespace {

namespace fs = std::filesystem;

TEST(AttemptLogs, AreThoseOfTheLastAttemptAndOfAllBefore) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "movedMesh");
  writeText(folder / "movedMesh/log.checkMesh", "moved");
  writeText(folder / "log.blockMesh", "first");
  writeText(folder / "case.foam", "");
  const std::map<fs::path, std::string> expected = {{"movedMesh/log.checkMesh", "moved"},
                                                    {"firstAttempt/log.blockMesh", "first"}};
  EXPECT_EQ(attemptLogs(folder.path(), firstAttemptLogs), expected);
}

TEST(AttemptLogs, AreNoneOfAFolderThatIsNotThere) {
  const TemporaryFolder folder;
  EXPECT_TRUE(attemptLogs(folder / "absent", movedMeshLogs).empty());
}

}  // namespace
}  // namespace restenosis

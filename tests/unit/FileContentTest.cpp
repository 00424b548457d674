#include <gtest/gtest.h>
#include <sys/stat.h>

#include "bridge/system/FileContent.h"
#include "tests/support/TemporaryFolder.h"

namespace restenosis {
namespace {

class FileContent : public ::testing::Test {
 protected:
  /// What keeps it from being read, and that it is refused for the same reason; neither may wait.
  std::string obstacle(const std::filesystem::path& file, std::uintmax_t most = largestFile) const {
    const std::string reason = fileObstacle(file, most);
    try {
      contentOf(file, most);
      ADD_FAILURE() << file << " was read";
    } catch (const std::runtime_error& error) {
      EXPECT_EQ(std::string(error.what()).rfind(file.string() + " ", 0), 0u) << error.what();
    }
    return reason;
  }
  TemporaryFolder folder;
};

TEST_F(FileContent, IsAllOfAFile) {
  const std::string text("a\0b\n", 4);
  writeText(folder / "file", text);
  EXPECT_EQ(fileObstacle(folder / "file", 4), "");
  EXPECT_EQ(contentOf(folder / "file", 4), text);
  writeText(folder / "empty", "");
  EXPECT_EQ(contentOf(folder / "empty"), "");
}

TEST_F(FileContent, IsOfNoPipeFolderOrDevice) {
  const std::string pipe = folder / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(obstacle(pipe), "is a pipe, not a file");
  EXPECT_EQ(obstacle("/dev/zero"), "is a device, not a file");
  EXPECT_EQ(obstacle(folder.path()), "is a folder, not a file");
  EXPECT_EQ(obstacle(folder / "none"), "does not exist");
  EXPECT_EQ(obstacle(folder / "pipe/file"), "does not exist");
  EXPECT_NE(obstacle(folder / std::string(300, 'a')).find("cannot be reached: "), std::string::npos);
}

TEST_F(FileContent, IsOfNoFileLargerThanAllowed) {
  writeText(folder / "file", "12345");
  EXPECT_EQ(obstacle(folder / "file", 4), "is larger than 4 bytes, the most that is read");
  writeText(folder / "sparse", "");
  std::filesystem::resize_file(folder / "sparse", std::uintmax_t{1} << 40);
  EXPECT_EQ(obstacle(folder / "sparse"), "is larger than 2048 MiB, the most that is read");
}

TEST_F(FileContent, OfTheSystemsOwnFilesTellsNoSize) {
  EXPECT_GT(contentOf("/proc/self/status").size(), 100u);
  EXPECT_THROW(contentOf("/proc/self/status", 100), std::runtime_error);
}

}  // namespace
}  // namespace restenosis

#include <gtest/gtest.h>

#include "bridge/system/AtomicFile.h"
#include "tests/support/FileSizeLimit.h"
#include "tests/support/TemporaryFolder.h"

namespace restenosis {
namespace {

TEST(AtomicFile, ReplacesAFileAndLeavesNothingElse) {
  TemporaryFolder folder;
  atomicWrite(folder / "a.txt", "first");
  atomicWrite(folder / "a.txt", "second");
  EXPECT_EQ(readText(folder / "a.txt"), "second");
  EXPECT_FALSE(std::filesystem::exists(folder / "a.txt.partial"));
}

TEST(AtomicFile, OverwritesWhatAKilledRunLeft) {
  TemporaryFolder folder;
  writeText(folder / "a.txt.partial", "half of something much longer");
  atomicWrite(folder / "a.txt", "whole");
  EXPECT_EQ(readText(folder / "a.txt"), "whole");
}

TEST(AtomicFile, KeepsTheOldFileWhenTheDiskIsFull) {
  TemporaryFolder folder;
  atomicWrite(folder / "a.txt", "old");
  FileSizeLimit full(4096);
  try {
    atomicWrite(folder / "a.txt", std::string(100000, 'x'));
    FAIL() << "wrote beyond the limit";
  } catch (const WriteFailed& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("a.txt"), std::string::npos) << message;
    EXPECT_NE(message.find("make room"), std::string::npos) << message;
  }
  EXPECT_EQ(readText(folder / "a.txt"), "old");
  EXPECT_FALSE(std::filesystem::exists(folder / "a.txt.partial"));
}

TEST(AtomicFile, TellsAFolderWithoutRoom) {
  TemporaryFolder folder;
  EXPECT_NO_THROW(requireRoom(folder.path()));
  for (const rlim_t bytes : {0, 4096}) {
    FileSizeLimit full(bytes);
    EXPECT_THROW(requireRoom(folder.path()), WriteFailed) << bytes;
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(AtomicFile, NamesAFolderThatIsNotThere) {
  TemporaryFolder folder;
  EXPECT_THROW(atomicWrite(folder / "missing/a.txt", "text"), WriteFailed);
}

TEST(AtomicFile, CannotCreateAFolderWhereAFileIs) {
  TemporaryFolder folder;
  writeText(folder / "file", "");
  EXPECT_THROW(createFolder(folder / "file"), WriteFailed);
  EXPECT_THROW(createFolder(folder / "file/below"), WriteFailed);
}

TEST(AtomicFile, LinksAreReplacedAndRemovedWithoutWhatTheyLeadTo) {
  TemporaryFolder folder;
  writeText(folder / "important", "mine");
  for (const char* name : {"file", "file.partial"})
    std::filesystem::create_symlink(folder / "important", folder / name);
  atomicWrite(folder / "file", "written");
  EXPECT_EQ(readText(folder / "file"), "written");
  EXPECT_FALSE(std::filesystem::is_symlink(folder / "file"));
  std::filesystem::create_symlink(folder / "important", folder / "link");
  removeIfLink(folder / "link");
  EXPECT_FALSE(std::filesystem::exists(folder / "link"));
  EXPECT_NO_THROW(removeIfLink(folder / "nowhere"));
  removeIfLink(folder / "important");
  EXPECT_EQ(readText(folder / "important"), "mine");
}

}  // namespace
}  // namespace restenosis

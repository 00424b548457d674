#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include "bridge/output/Checkpoint.h"
#include "bridge/system/AtomicFile.h"
#include "tests/support/FileSizeLimit.h"
#include "tests/support/TemporaryFolder.h"

namespace restenosis {
namespace {

using Reason = CheckpointRefused::Reason;

const std::string state = "a state" + std::string(5000, '\1');

/// The reason for which a checkpoint is refused, and that its message holds a word.
Reason refusal(const Checkpoint& checkpoint, const std::string& fingerprint, const std::string& word) {
  try {
    checkpoint.load(fingerprint);
  } catch (const CheckpointRefused& error) {
    EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("state.bin"), std::string::npos) << error.what();
    return error.reason;
  }
  throw std::logic_error("the checkpoint was accepted");
}

TEST(Checkpoint, GivesBackWhatWasSaved) {
  TemporaryFolder folder;
  const Checkpoint checkpoint(folder / "checkpoint");
  EXPECT_FALSE(checkpoint.exists());
  checkpoint.save("scene", "older");
  checkpoint.save("scene", state);
  EXPECT_EQ(checkpoint.load("scene"), state);
  checkpoint.save("scene", "");
  EXPECT_EQ(checkpoint.load("scene"), "");
}

TEST(Checkpoint, KeepsWhereAStateComesFrom) {
  TemporaryFolder folder;
  const CheckpointOrigin there{{{"compiler", "11"}}, {{"stent.file", "aa"}, {"vessel.agents", "bb"}}};
  const CheckpointOrigin here{{{"compiler", "12"}}, {{"stent.file", "aa"}, {"vessel.agents", "cc"}}};
  Checkpoint(folder.path(), there).save("scene", state);
  const Checkpoint checkpoint(folder.path(), here);
  const StoredState stored = checkpoint.loadWithOrigin("scene");
  EXPECT_EQ(stored.bytes, state);
  EXPECT_EQ(stored.origin.traits, there.traits);
  EXPECT_EQ(stored.origin.inputs, there.inputs);
  try {
    checkpoint.load("other");
    ADD_FAILURE() << "the checkpoint was accepted";
  } catch (const CheckpointRefused& refused) {
    EXPECT_EQ(refused.changedInputs, std::vector<std::string>{"vessel.agents"});
  }
}

TEST(Checkpoint, IsUnharmedByAPartialOne) {
  TemporaryFolder folder;
  const Checkpoint checkpoint(folder.path());
  checkpoint.save("scene", state);
  writeText(folder / "state.bin.partial", readText(checkpoint.file()).substr(0, 100));
  EXPECT_EQ(checkpoint.load("scene"), state);
  checkpoint.save("scene", "newer");
  EXPECT_EQ(checkpoint.load("scene"), "newer");
}

TEST(Checkpoint, RefusesWhatIsMissing) {
  TemporaryFolder folder;
  EXPECT_EQ(refusal(Checkpoint(folder / "checkpoint"), "scene", "is not there"), Reason::missing);
}

TEST(Checkpoint, RefusesAFolderInItsPlace) {
  TemporaryFolder folder;
  const Checkpoint checkpoint(folder.path());
  std::filesystem::create_directory(checkpoint.file());
  EXPECT_EQ(refusal(checkpoint, "scene", "cannot be read: Is a directory"), Reason::missing);
}

TEST(Checkpoint, RefusesWhatMayNotBeRead) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may read everything";
  TemporaryFolder folder;
  const Checkpoint checkpoint(folder / "checkpoint");
  checkpoint.save("scene", state);
  std::filesystem::permissions(folder / "checkpoint", std::filesystem::perms::none);
  EXPECT_TRUE(checkpoint.exists());
  EXPECT_EQ(refusal(checkpoint, "scene", "cannot be read: Permission denied"), Reason::missing);
  std::filesystem::permissions(folder / "checkpoint", std::filesystem::perms::owner_all);
}

TEST(Checkpoint, RefusesEveryTruncation) {
  TemporaryFolder folder;
  const Checkpoint checkpoint(folder.path());
  checkpoint.save("scene", state);
  const auto whole = readText(checkpoint.file());
  for (std::size_t size = 0; size < whole.size(); size += size < 100 ? 3 : 1531) {
    writeText(checkpoint.file(), whole.substr(0, size));
    EXPECT_EQ(refusal(checkpoint, "scene", "cut off"), Reason::truncated) << size;
  }
}

TEST(Checkpoint, RefusesEveryFlippedBit) {
  TemporaryFolder folder;
  const Checkpoint checkpoint(folder.path());
  checkpoint.save("scene", state);
  const auto whole = readText(checkpoint.file());
  for (std::size_t at = 0; at < whole.size(); at += at < 100 ? 3 : 1531) {
    auto damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ 4);
    writeText(checkpoint.file(), damaged);
    EXPECT_THROW(checkpoint.load("scene"), CheckpointRefused) << at;
  }
  auto damaged = whole;
  damaged.back() ^= 1;
  writeText(checkpoint.file(), damaged);
  EXPECT_EQ(refusal(checkpoint, "scene", "checksum"), Reason::corrupt);
  writeText(checkpoint.file(), whole + "x");
  EXPECT_EQ(refusal(checkpoint, "scene", "checksum"), Reason::corrupt);
}

TEST(Checkpoint, RefusesOneOfAnotherScene) {
  TemporaryFolder folder;
  const Checkpoint checkpoint(folder.path());
  checkpoint.save("scene", state);
  EXPECT_EQ(refusal(checkpoint, "other", "another scene"), Reason::foreign);
}

TEST(Checkpoint, RefusesOtherFilesAndFormats) {
  TemporaryFolder folder;
  const Checkpoint checkpoint(folder.path());
  writeText(checkpoint.file(), "something else altogether, long enough for a header");
  EXPECT_EQ(refusal(checkpoint, "scene", "not a checkpoint"), Reason::notACheckpoint);
  checkpoint.save("scene", state);
  auto later = readText(checkpoint.file());
  later[8] = 99;
  writeText(checkpoint.file(), later);
  EXPECT_EQ(refusal(checkpoint, "scene", "format 99"), Reason::otherFormat);
}

TEST(Checkpoint, KeepsTheFormerOneWhenTheDiskIsFull) {
  TemporaryFolder folder;
  const Checkpoint checkpoint(folder.path());
  checkpoint.save("scene", state);
  {
    FileSizeLimit full(8192);
    EXPECT_THROW(checkpoint.save("scene", std::string(1 << 20, 'y')), WriteFailed);
  }
  EXPECT_EQ(checkpoint.load("scene"), state);
}

TEST(Checkpoint, IsWholeAfterAKillAtAnyMoment) {
  TemporaryFolder folder;
  const Checkpoint checkpoint(folder.path());
  checkpoint.save("scene", std::string(100000, '0'));
  for (int kill = 0; kill < 10; ++kill) {
    const pid_t writer = ::fork();
    if (writer == 0) {
      for (char content = 'a';; content = content == 'z' ? 'a' : static_cast<char>(content + 1))
        checkpoint.save("scene", std::string(100000, content));
    }
    ::usleep(3000 + 1700 * kill);
    ::kill(writer, SIGKILL);
    ::waitpid(writer, nullptr, 0);
    const auto loaded = checkpoint.load("scene");
    ASSERT_EQ(loaded, std::string(100000, loaded.at(0)));
  }
}

}  // namespace
}  // namespace restenosis

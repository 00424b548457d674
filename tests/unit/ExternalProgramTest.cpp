#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>

#include <atomic>
#include <chrono>
#include <string>
#include <thread>

#include "ExternalProgram.h"
#include "TemporaryFolder.h"

namespace restenosis {
namespace {

template <class Condition>
bool until(Condition condition) {
  for (int i = 0; i < 500 && !condition(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  return condition();
}

/// Gone, or dead and waiting for init.
bool hasEnded(pid_t process) {
  return until([&] {
    const auto stat = readText("/proc/" + std::to_string(process) + "/stat");
    return stat.empty() || stat.find(") Z ") != std::string::npos;
  });
}

TEST(ExternalProgram, missingProgramIsNamed) {
  try {
    ExternalProgram("noSuchProgramHere");
    FAIL();
  } catch (const ProgramMissing& error) {
    EXPECT_EQ(error.program, "noSuchProgramHere");
    EXPECT_NE(std::string(error.what()).find("PATH"), std::string::npos);
  }
}

TEST(ExternalProgram, outputErrorsAndStatusArrive) {
  const TemporaryFolder scratch;
  const auto log = scratch.path() / "log";
  const auto exit = ExternalProgram("sh")
                        .setEnvironment("GREETING", "a b;c")
                        .run({"-c", "echo \"$GREETING\"; pwd; echo wrong >&2; exit 3"}, scratch.path(), log);
  EXPECT_FALSE(exit.succeeded());
  EXPECT_EQ(exit.status, 3);
  EXPECT_EQ(exit.describe(), "exit status 3");
  EXPECT_EQ(readText(log), "a b;c\n" + scratch.path().string() + "\nwrong\n");
}

TEST(ExternalProgram, argumentsAreNotInterpreted) {
  const TemporaryFolder scratch;
  EXPECT_TRUE(ExternalProgram("echo").run({"$HOME; *"}, scratch.path(), scratch.path() / "log").succeeded());
  EXPECT_EQ(readText(scratch.path() / "log"), "$HOME; *\n");
}

TEST(ExternalProgram, signalIsTold) {
  const TemporaryFolder scratch;
  const auto killed = ExternalProgram("sh").run({"-c", "kill -9 $$"}, scratch.path(), scratch.path() / "log");
  EXPECT_EQ(killed.signal, SIGKILL);
  EXPECT_FALSE(killed.interrupted());
  const auto stopped =
      ExternalProgram("sh").run({"-c", "kill -15 $$"}, scratch.path(), scratch.path() / "log");
  EXPECT_TRUE(stopped.interrupted());
}

TEST(ExternalProgram, missingFolderIsAnError) {
  const TemporaryFolder scratch;
  EXPECT_THROW(ExternalProgram("true").run({}, scratch.path() / "absent", scratch.path() / "log"),
               std::runtime_error);
  EXPECT_THROW(ExternalProgram("true").run({}, scratch.path(), scratch.path() / "absent/log"),
               std::runtime_error);
}

TEST(ExternalProgram, endsWithItsChildrenWhenAskedTo) {
  const TemporaryFolder scratch;
  const auto log = scratch.path() / "log";
  std::atomic<bool> stop{false};
  std::thread asking([&] {
    until([&] { return readText(log).ends_with('\n'); });
    stop = true;
  });
  const auto exit =
      ExternalProgram("sh").stopWhen(&stop).run({"-c", "sleep 30 & echo $!; wait"}, scratch.path(), log);
  asking.join();
  EXPECT_TRUE(exit.stopped);
  EXPECT_TRUE(exit.interrupted());
  EXPECT_LT(exit.seconds, 20.0);
  EXPECT_TRUE(hasEnded(std::stoi(readText(log))));
}

TEST(ExternalProgram, endsByItselfWhenNotAskedTo) {
  const TemporaryFolder scratch;
  const std::atomic<bool> stop{false};
  const auto exit =
      ExternalProgram("sh").stopWhen(&stop).run({"-c", "exit 3"}, scratch.path(), scratch / "log");
  EXPECT_EQ(exit.status, 3);
  EXPECT_FALSE(exit.stopped);
}

TEST(ExternalProgram, endsWithItsChildrenWhenItTakesTooLong) {
  const TemporaryFolder scratch;
  const auto log = scratch.path() / "log";
  const auto exit = ExternalProgram("sh")
                        .stopAfter(std::chrono::seconds(1))
                        .run({"-c", "sleep 30 & echo $!; wait"}, scratch.path(), log);
  EXPECT_TRUE(exit.late);
  EXPECT_FALSE(exit.stopped);
  EXPECT_LT(exit.seconds, 20.0);
  EXPECT_TRUE(hasEnded(std::stoi(readText(log))));
}

TEST(ExternalProgram, isFoundWhereItsNameSays) {
  const TemporaryFolder scratch;
  EXPECT_EQ(ExternalProgram("/bin/sh").run({"-c", "exit 4"}, scratch.path(), scratch / "log").status, 4);
  EXPECT_THROW(ExternalProgram("/nowhere/sh"), ProgramMissing);
}

TEST(ExternalProgram, diesWithItsParent) {
  const TemporaryFolder scratch;
  const auto log = scratch.path() / "log";
  const pid_t parent = fork();
  if (parent == 0) {
    ExternalProgram("sh").run({"-c", "echo $$; exec sleep 30"}, scratch.path(), log);
    _exit(0);
  }
  ASSERT_TRUE(until([&] { return readText(log).ends_with('\n'); }));
  const pid_t child = std::stoi(readText(log));
  ASSERT_EQ(kill(child, 0), 0);
  kill(parent, SIGKILL);
  waitpid(parent, nullptr, 0);
  EXPECT_TRUE(hasEnded(child));
}

}  // namespace
}  // namespace restenosis

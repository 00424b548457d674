#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>

#include <atomic>
#include <chrono>
#include <string>
#include <thread>

#include "bridge/system/ExternalProgram.h"
#include "tests/support/EnvironmentVariable.h"
#include "tests/support/TemporaryFolder.h"

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

TEST(ExternalProgram, isToldTheFolderThatItRunsIn) {
  const TemporaryFolder scratch;
  const std::string odd = "a b \"c\" 'd' $HOME \xc3\xa4\n";
  std::filesystem::create_directories(scratch / odd);
  const EnvironmentVariable shells("PWD",
                                   "/");  // of another program, as a shell leaves it that has gone elsewhere
  ExternalProgram("sh").run({"-c", "printenv PWD"}, scratch / odd, scratch / "log");
  EXPECT_EQ(readText(scratch / "log"), (scratch / odd).string() + '\n');
}

TEST(ExternalProgram, doesNotHaveVariablesThatAreLeftOut) {
  const TemporaryFolder scratch;
  const EnvironmentVariable left("RF_TEST_LEFT", "1"), set("RF_TEST_SET", "1"), other("RF_OTHER", "1");
  ExternalProgram("sh")
      .withoutEnvironment([](std::string_view variable) { return variable.starts_with("RF_TEST_"); })
      .setEnvironment("RF_TEST_SET", "2")
      .run({"-c", "echo \"$RF_TEST_LEFT,$RF_TEST_SET,$RF_OTHER\""}, scratch.path(), scratch / "log");
  EXPECT_EQ(readText(scratch / "log"), ",2,1\n");
}

TEST(ExternalProgram, endsWithItsChildrenWhenItsLogNoLongerGrows) {
  const TemporaryFolder scratch;
  const auto log = scratch.path() / "log";
  const auto exit = ExternalProgram("sh")
                        .stopWhenSilentFor(std::chrono::milliseconds(50))
                        .run({"-c", "sleep 1000 & echo $!; wait"}, scratch.path(), log);
  EXPECT_TRUE(exit.silent);
  EXPECT_FALSE(exit.stopped);
  EXPECT_FALSE(exit.interrupted());
  const std::string child = readText(log);  // empty where it had not come so far
  EXPECT_TRUE(child.empty() || hasEnded(std::stoi(child)));
}

TEST(ExternalProgram, isNotSilentWhileItSaysSomethingOrEndsByItself) {
  const TemporaryFolder scratch;
  const auto exit = ExternalProgram("sh")
                        .stopWhenSilentFor(std::chrono::minutes(10))
                        .run({"-c", "echo a; exit 3"}, scratch.path(), scratch / "log");
  EXPECT_FALSE(exit.silent);
  EXPECT_EQ(exit.status, 3);
}

TEST(ExternalProgram, canBeInterruptedWhileItHangs) {
  const TemporaryFolder scratch;
  const auto log = scratch.path() / "log";
  std::atomic<bool> stop{false};
  std::thread asking([&] {
    until([&] { return readText(log).ends_with('\n'); });
    stop = true;
  });
  const auto exit = ExternalProgram("sh")
                        .stopWhen(&stop)
                        .stopWhenSilentFor(std::chrono::minutes(10))
                        .run({"-c", "echo a; sleep 1000"}, scratch.path(), log);
  asking.join();
  EXPECT_TRUE(exit.stopped);
  EXPECT_FALSE(exit.silent);
}

TEST(ExternalProgram, doesNotIgnoreWhatThisOneWasStartedToIgnore) {
  const TemporaryFolder scratch;
  const auto before = signal(SIGINT, SIG_IGN);
  const auto exit =
      ExternalProgram("sh").run({"-c", "kill -INT $$; sleep 1000"}, scratch.path(), scratch / "log");
  signal(SIGINT, before);
  EXPECT_EQ(exit.signal, SIGINT);
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

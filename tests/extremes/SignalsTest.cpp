#include <memory>
#include <thread>

#include "tests/support/WholeProgram.h"

namespace restenosis {
namespace {

/// The program told to end, in whatever state its starter has left it.
class Signals : public WholeProgram {
 protected:
  /// The arguments of a shell that runs the program after this command of its own.
  static std::vector<std::string> after(const std::string& shellCommand, std::vector<std::string> arguments) {
    std::vector<std::string> all = {"/bin/sh", "-c", shellCommand + "; exec \"$0\" \"$@\""};
    std::ranges::move(command(std::move(arguments)), std::back_inserter(all));
    return all;
  }
  /// A run of many days, in growth.
  std::unique_ptr<Process> growing(const std::string& shellCommand) const {
    const std::string tiny = scene("tiny", with(tinyScene, "\"4 d\"", "\"400 d\""));
    std::filesystem::remove_all(folder / "out");
    auto process = std::make_unique<Process>(
        after(shellCommand, {"run", tiny, "-o", "out", "--flow", "none"}), folder.path());
    waitFor(*process, [&] { return exists("out/timeSeries.csv"); });
    return process;
  }
  template <class Condition>
  static void waitFor(Process& process, Condition condition) {
    while (process.running() && !condition()) std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  void expectInterrupted(const ProcessEnd& end, const std::string& saved = ", saved at day ") const {
    EXPECT_EXIT_STATUS(end, 1);
    EXPECT_NE(end.err.find("\ninterrupted" + saved), std::string::npos) << end.err;
    EXPECT_NE(end.err.find(" --resume`\n"), std::string::npos) << end.err;
    EXPECT_EQ(summary("out")["status"], "interrupted");
  }
};

/// As a script that starts it with `&` does.
TEST_F(Signals, ThatItWasStartedToIgnoreEndIt) {
  for (const int signal : {SIGINT, SIGTERM}) {
    SCOPED_TRACE(signal);
    const auto run = growing("trap '' INT TERM");
    run->send(signal);
    expectInterrupted(run->wait(patience));
  }
}

TEST_F(Signals, AClosedTerminalEndsItInOrder) {
  const auto run = growing("true");
  run->send(SIGHUP);
  run->send(SIGHUP);
  expectInterrupted(run->wait(patience));
}

TEST_F(Signals, AClosedTerminalDoesNotEndWhatNohupHasStarted) {
  const auto run = growing("trap '' HUP");
  run->send(SIGHUP);
  const std::string before = readText(folder / "out/timeSeries.csv");
  waitFor(*run, [&] { return readText(folder / "out/timeSeries.csv") != before; });
  EXPECT_TRUE(run->running());
}

TEST_F(Signals, PackingHeedsThem) {
  const std::string vessel = scene("vessel",
                                   "[scene]\nduration = \"1 d\"\nstep = \"1 h\"\n[vessel]\nlength = \"4.5 "
                                   "mm\"\nlumenDiameter = \"1.8 mm\"\n[mechanics]\n");
  Process process(command({"run", vessel, "-o", "out"}), folder.path());
  waitFor(process, [&] { return process.errorsSoFar().find("packing the wall") != std::string::npos; });
  process.send(SIGINT);
  expectInterrupted(process.wait(patience), ", nothing saved yet: begin again with `");
  EXPECT_FALSE(exists("out/checkpoint/state.bin")) << "it has packed the wall to the end";
}

}  // namespace
}  // namespace restenosis

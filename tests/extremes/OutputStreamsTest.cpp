#include "tests/support/WholeProgram.h"

namespace restenosis {
namespace {

/// Standard output and error that cannot be written, or that nobody reads.
class OutputStreams : public WholeProgram {
 protected:
  /// Runs the program with this redirection of a shell.
  ProcessEnd redirected(const std::string& redirection, std::vector<std::string> arguments) const {
    std::vector<std::string> all = {"/bin/bash", "-o", "pipefail", "-c", "\"$0\" \"$@\" " + redirection};
    std::ranges::move(command(std::move(arguments)), std::back_inserter(all));
    return Process(all, folder.path()).wait(patience);
  }
};

TEST_F(OutputStreams, OutputThatCannotBeWrittenIsAFailure) {
  const std::string tiny = scene("tiny", tinyScene);
  for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
           {"schema", "--markdown"}, {"schema"}, {"check", tiny}, {"--help"}, {"--version"}}) {
    SCOPED_TRACE(arguments.front());
    const ProcessEnd full = redirected(">/dev/full", arguments);
    EXPECT_EXIT_STATUS(full, 1);
    EXPECT_EQ(full.err, "the output could not be written: No space left on device\n");
    const ProcessEnd closed = redirected(">&-", arguments);
    EXPECT_EXIT_STATUS(closed, 1);
    EXPECT_EQ(closed.err, "the output could not be written: Bad file descriptor\n");
  }
}

TEST_F(OutputStreams, WrongInputIsWrongInputAllTheSame) {
  EXPECT_EXIT_STATUS(redirected(">/dev/full", {"check", "none.toml"}), 2);
}

TEST_F(OutputStreams, AReaderThatHasReadEnoughIsNoFailure) {
  const ProcessEnd end = redirected("| head -1", {"schema", "--markdown"});
  EXPECT_EXIT_STATUS(end, 0);
  EXPECT_EQ(end.err, "");
}

TEST_F(OutputStreams, ARunGoesOnWhenNobodyReadsItsProgress) {
  const std::string tiny = scene("tiny", tinyScene);
  for (const char* redirection :
       {"2>&1 | head -1", "2>&1 | true", "2>&- | head -1", ">/dev/null 2>/dev/full"}) {
    SCOPED_TRACE(redirection);
    std::filesystem::remove_all(folder / "out");
    EXPECT_EXIT_STATUS(
        redirected(redirection, {"run", tiny, "-o", "out", "--flow", "none", "--set", "scene.duration=1 d"}),
        0);
    EXPECT_EQ(summary("out")["status"], "finished");
  }
}

}  // namespace
}  // namespace restenosis

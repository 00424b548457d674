#include <gtest/gtest.h>

#include <vector>

#include "bridge/system/ShellCommand.h"

namespace restenosis {
namespace {

std::string shell(const std::vector<std::string>& arguments) { return shellCommand(arguments); }

TEST(ShellCommand, LeavesPlainArgumentsAsTheyAre) {
  EXPECT_EQ(shell({"build/release/restenosisFoam", "run", "scenes/quick.toml", "--set=scene.seed=2"}),
            "build/release/restenosisFoam run scenes/quick.toml --set=scene.seed=2");
}

TEST(ShellCommand, QuotesWhatAShellReadsForItself) {
  EXPECT_EQ(shell({"run", "my scene.toml", "scene.duration=3 d"}),
            "run 'my scene.toml' 'scene.duration=3 d'");
  EXPECT_EQ(shell({"a", "", "b"}), "a '' b");
  EXPECT_EQ(shell({"$HOME", "`x`", "~", "*"}), "'$HOME' '`x`' '~' '*'");
  EXPECT_EQ(shell({"it's"}), R"('it'\''s')");
}

}  // namespace
}  // namespace restenosis

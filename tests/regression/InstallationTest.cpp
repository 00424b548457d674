#include <regex>
#include <set>

#include "tests/support/WholeProgram.h"

namespace restenosis {
namespace {

namespace fs = std::filesystem;

/// The program as it is installed, in a folder that was moved after that.
class Installation : public WholeProgram {
 protected:
  void SetUp() override {
    const fs::path build = fs::path(RESTENOSIS_PROGRAM).parent_path();
    const fs::path first = folder / "first";
    const ProcessEnd end =
        Process({"/usr/bin/env", "cmake", "--install", build.string(), "--prefix", first.string()},
                folder.path())
            .wait(patience);
    ASSERT_EXIT_STATUS(end, 0);
    fs::rename(first, prefix());
  }
  fs::path prefix() const { return folder / "moved"; }
  fs::path data() const { return prefix() / "share/restenosisFoam"; }
  std::string program() const { return (prefix() / "bin/restenosisFoam").string(); }
  /// Runs the installed program to its end.
  ProcessEnd installed(std::vector<std::string> arguments, Environment environment = {}) const {
    arguments.insert(arguments.begin(), program());
    environment.try_emplace("OMP_WAIT_POLICY", "passive");
    return Process(arguments, folder.path(), environment).wait(patience);
  }
  static std::set<std::string> optionsIn(const std::string& text) {
    std::set<std::string> options;
    const std::regex option("--[a-z][a-z-]*");
    for (std::sregex_iterator found(text.begin(), text.end(), option), end; found != end; ++found)
      options.insert(found->str());
    return options;
  }
};

TEST_F(Installation, ChecksAndRunsItsOwnScenes) {
  const std::string scene = (data() / "scenes/poiseuille.toml").string();
  EXPECT_EXIT_STATUS(installed({"check", scene}), 0);
  EXPECT_EXIT_STATUS(
      installed({"run", scene, "--flow", "analytic", "-o", "out", "--set", "output.pictures=false"}), 0);
  EXPECT_EQ(summary("out")["status"], "finished");
}

/// Its own, and not those of the sources.
TEST_F(Installation, TakesTemplateAndFiguresFromItsOwnFolder) {
  writeText(data() / "foamCase/README.md", "the installed one");
  writeText(data() / "figures/__main__.py",
            "import pathlib, sys\npathlib.Path(sys.argv[1], 'report.html').write_text('installed')\n");
  const std::string tube = scene("tube", R"([scene]
duration = "1 h"
fidelity = "draft"
[vessel]
length = "0.4 mm"
lumenDiameter = "1.2 mm"
[flow]
drive = "flowRate"
)");
  EXPECT_EXIT_STATUS(installed({"run", tube, "-o", "drawn", "--flow", "analytic"}), 0);
  EXPECT_EQ(readText(folder / "drawn/report.html"), "installed");

  const fs::path bin = folder / "bin";
  fs::create_directory(bin);
  for (const char* name : {"blockMesh", "snappyHexMesh", "checkMesh", "simpleFoam"}) {
    writeText(bin / name, "#!/bin/sh\nexit 1\n");
    fs::permissions(bin / name, fs::perms::owner_all);
  }
  EXPECT_EXIT_STATUS(installed({"run", tube, "-o", "solved"}, {{"PATH", bin.string() + ":/usr/bin:/bin"}}),
                     1);
  EXPECT_EQ(readText(folder / "solved/flow/0/README.md"), "the installed one");
}

TEST_F(Installation, SaysWhereItsTemplateShouldBe) {
  fs::remove_all(data() / "foamCase");
  const ProcessEnd end = installed({"run", (data() / "scenes/poiseuille.toml").string(), "-o", "out"});
  EXPECT_EXIT_STATUS(end, 1);
  const std::string place = (fs::canonical(data()) / "foamCase").string();
  EXPECT_NE(end.err.find("no whole OpenFOAM case template in " + place), std::string::npos) << end.err;
}

TEST_F(Installation, ItsManualHasEveryOption) {
  const std::string page =
      std::regex_replace(readText(prefix() / "share/man/man1/restenosisFoam.1"), std::regex(R"(\\-)"), "-");
  const std::set<std::string> described = optionsIn(page);
  for (const char* command : {"run", "check", "compare", "tradeoff", "schema", "bench"}) {
    EXPECT_NE(page.find(command), std::string::npos) << command;
    for (const std::string& option : optionsIn(installed({command, "--help"}).out)) {
      const bool ofTheLauncher = option == "--mpi" || option == "--hostfile";
      EXPECT_TRUE(ofTheLauncher || described.contains(option)) << command << " " << option;
    }
  }
}

TEST_F(Installation, TheShellCompletesCommandsAndOptions) {
  const fs::path script = prefix() / "share/bash-completion/completions/restenosisFoam";
  const auto completed = [&](const std::string& words, int at) {
    const std::string commands = ". " + script.string() + "; COMP_WORDS=(" + program() + " " + words +
                                 "); COMP_CWORD=" + std::to_string(at) +
                                 "; _restenosisFoam; printf '[%s]' \"${COMPREPLY[@]}\"";
    return Process({"/usr/bin/env", "bash", "-c", commands}, folder.path()).wait(patience).out;
  };
  EXPECT_EQ(completed("che", 1), "[check]");
  EXPECT_EQ(completed("run a.toml --res", 3), "[--resume]");
  EXPECT_EQ(completed("run a.toml --flow l", 4), "[lbm]");
  writeText(folder / "mine.toml", "");
  writeText(folder / "mine.stl", "");
  EXPECT_EQ(completed("run mi", 2), "[mine.toml]");
}

TEST_F(Installation, AStudyFindsTheInstalledProgram) {
  const std::string start = (data() / "studies/start").string();
  const ProcessEnd end =
      Process({start, "thesis", "-n"}, folder.path(), {{"PATH", "/usr/bin:/bin"}}).wait(patience);
  EXPECT_EQ(end.err.find("is not built"), std::string::npos) << toString(end);
  EXPECT_EQ(end.err.find("thesisInjury1.toml:"), std::string::npos) << toString(end);
}

}  // namespace
}  // namespace restenosis

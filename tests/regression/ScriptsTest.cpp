#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/support/Process.h"
#include "tests/support/TinyScene.h"

namespace restenosis {
namespace {

namespace fs = std::filesystem;

/// The scripts that a user starts, in a checkout of their own in which nothing is installed or built: what
/// they start says how it was started.
class Scripts : public ::testing::Test {
 protected:
  Scripts() {
    fs::create_directories(checkout / "cmake");
    for (const char* file : {"Allrun", "Alltest", "Allclean", "cmake/setup.sh", "cmake/packages.txt"})
      fs::copy(fs::path(RESTENOSIS_SOURCE_DIR) / file, checkout / file);
    fs::copy(fs::path(RESTENOSIS_SOURCE_DIR) / "foamCase", checkout / "foamCase",
             fs::copy_options::recursive);
    program(checkout / "build/release/restenosisFoam", R"(echo "in $PWD"; printf '[%s]' "$@")");
    program(folder / "bin/ctest", R"(printf '[%s]' "$@")");
    program(folder / "bin/cmake", ":");
    program(folder / "bin/dpkg-query", "echo install ok installed");
    fs::create_directories(elsewhere);
    fs::create_directories(checkout / "scenes");
    for (const char* scene : {"scenes/quick.toml", "my.toml", "my", "a.toml", "b.toml", "c.toml"})
      writeText(checkout / scene, "[scene]\n");
  }
  static void program(const fs::path& file, const std::string& commands) {
    fs::create_directories(file.parent_path());
    writeText(file, "#!/bin/sh\n" + commands + "\n");
    fs::permissions(file, fs::perms::owner_all);
  }
  /// What is written by the script, started in a folder.
  std::string start(const std::string& script, std::vector<std::string> arguments, const fs::path& at) const {
    arguments.insert(arguments.begin(), (checkout / script).string());
    const std::string path = (folder / "bin").string() + ":" + std::getenv("PATH");
    const ProcessEnd end = Process(arguments, at, {{"PATH", path}}).wait(std::chrono::minutes(1));
    EXPECT_EQ(end.status, 0) << toString(end);
    return end.out;
  }
  /// Makes a file among the results.
  void result(const std::string& name) const {
    const fs::path file = checkout / "results" / name;
    fs::create_directories(file.parent_path());
    writeText(file, "made by a test\n");
  }
  /// How Allrun starts the program.
  std::string run(const std::vector<std::string>& arguments, const fs::path& at) const {
    const std::string out = start("Allrun", arguments, at), in = "in " + checkout.string() + "\n";
    const auto begin = out.find(in);
    EXPECT_NE(begin, std::string::npos) << out;
    return begin == std::string::npos ? out : out.substr(begin + in.size());
  }

  TemporaryFolder folder;
  const fs::path checkout = fs::canonical(folder.path()) / "checkout";
  const fs::path elsewhere = fs::canonical(folder.path()) / "elsewhere";
};

TEST_F(Scripts, AllrunFindsTheSceneAmongTheOptions) {
  EXPECT_EQ(run({}, checkout), "[run][scenes/quick.toml]");
  EXPECT_EQ(run({"--no-install", "--resume"}, checkout), "[run][scenes/quick.toml][--resume]");
  EXPECT_EQ(run({"my.toml", "--threads", "1"}, checkout), "[run][my.toml][--threads][1]");
  EXPECT_EQ(run({"--threads", "1", "my.toml"}, checkout), "[run][my.toml][--threads][1]");
  EXPECT_EQ(run({"--threads=1", "my"}, checkout), "[run][my][--threads=1]");
  EXPECT_EQ(run({"--set", "stent.file=a.toml", "--flow", "none", "--ranks", "2", "-o", "b.toml", "c.toml"},
                checkout),
            "[run][c.toml][--set][stent.file=a.toml][--flow][none][--ranks][2][-o][b.toml]");
  EXPECT_EQ(run({"-o", "out"}, checkout), "[run][scenes/quick.toml][-o][out]");
  EXPECT_EQ(run({"a.toml", "b.toml"}, checkout), "[run][a.toml][b.toml]") << "for the program to refuse";
  EXPECT_EQ(run({"", "-o", ""}, checkout), "[run][][-o][]") << "for the program to refuse";
  EXPECT_EQ(run({"-o"}, checkout), "[run][scenes/quick.toml][-o]") << "for the program to refuse";
}

TEST_F(Scripts, AllrunSeeksFilesWhereTheUserStands) {
  const std::string here = elsewhere.string() + "/", absolute = (checkout / "b.toml").string();
  writeText(elsewhere / "a.toml", "[scene]\n");
  EXPECT_EQ(run({}, elsewhere), "[run][scenes/quick.toml]");
  EXPECT_EQ(run({"a.toml", "-o", "out"}, elsewhere), "[run][" + here + "a.toml][-o][" + here + "out]");
  EXPECT_EQ(run({"-oout", absolute}, elsewhere), "[run][" + absolute + "][-o" + here + "out]");
  EXPECT_EQ(run({"--output=out", "--output", "/out"}, elsewhere),
            "[run][scenes/quick.toml][--output=" + here + "out][--output][/out]");
  EXPECT_EQ(run({"scenes/quick.toml"}, elsewhere), "[run][scenes/quick.toml]") << "beside the script";
  EXPECT_EQ(run({"quick"}, elsewhere), "[run][scenes/quick.toml]") << "by its name";
  fs::create_directories(elsewhere / "scenes");
  writeText(elsewhere / "scenes/quick.toml", "[scene]\n");
  EXPECT_EQ(run({"scenes/quick.toml"}, elsewhere), "[run][" + here + "scenes/quick.toml]")
      << "the user's own";
}

TEST_F(Scripts, AllrunRefusesASceneThatIsNotThereBeforeItBuilds) {
  fs::remove(folder / "bin/cmake");
  const ProcessEnd end =
      Process({(checkout / "Allrun").string(), "quik"}, elsewhere).wait(std::chrono::minutes(1));
  EXPECT_EQ(end.status, 2) << toString(end);
  EXPECT_NE(end.err.find("quik: no such scene file; scenes/ has quick"), std::string::npos) << toString(end);
}

TEST_F(Scripts, AlltestIsNoSuccessWithoutATest) {
  const std::string some = start("Alltest", {"-L", "unit"}, elsewhere);
  EXPECT_NE(some.find("[--no-tests=error]"), std::string::npos) << some;
  EXPECT_NE(some.find("[-L][^unit$]"), std::string::npos) << some;
}

TEST_F(Scripts, AllcleanGoesBackToTheCheckout) {
  fs::create_directories(checkout / "scenes");
  writeText(checkout / "scenes/quick.toml", "[scene]\n");
  for (const char* file : {"quick/.restenosisFoam", "quick/summary.json", "quick/previous/scene.toml",
                           "quick/scene.toml.partial", "quick-compare/compare.json", "quick-tradeoff/runs/a"})
    result(file);
  fs::create_directories(checkout / "foamCase/constant/triSurface");
  fs::create_directories(checkout / "foamCase/0");
  const ProcessEnd example =
      Process({(checkout / "foamCase/makeExampleLumen").string()}, elsewhere).wait(std::chrono::minutes(1));
  writeText(checkout / "foamCase/constant/triSurface/lumen.stl", example.out);
  EXPECT_EQ(start("Allclean", {}, elsewhere), "");
  for (const char* left : {"build", "results", "foamCase/0", "foamCase/constant/triSurface"})
    EXPECT_FALSE(fs::exists(checkout / left)) << left;
  EXPECT_TRUE(fs::exists(checkout / "foamCase/0.orig/U"));
  EXPECT_TRUE(fs::exists(checkout / "foamCase/constant/transportProperties"));
}

TEST_F(Scripts, AllcleanLeavesTheUsersOwnAndNamesIt) {
  fs::create_directories(checkout / "scenes");
  for (const char* scene : {"quick", "noted", "kept", "running"})
    writeText(checkout / "scenes" / (std::string(scene) + ".toml"), "[scene]\n");
  for (const char* file :
       {"quick/summary.json", "mine/summary.json", "noted/notes.txt", "noted/summary.json",
        "kept/previous/notes.txt", "running/.restenosisFoam", "list.txt", "mine-compare/compare.json"})
    result(file);
  fs::create_directory_symlink(elsewhere, checkout / "results/linked");
  writeText(elsewhere / "thesis.doc", "years of work");
  fs::create_directories(checkout / "foamCase/constant/triSurface");
  fs::create_directories(checkout / "foamCase/100");
  writeText(checkout / "foamCase/constant/triSurface/lumen.stl", "solid wall\n");
  Process run({"/usr/bin/flock", (checkout / "results/running/.restenosisFoam").string(), "/bin/sleep", "60"},
              elsewhere);
  while (
      Process({"/usr/bin/flock", "-n", (checkout / "results/running/.restenosisFoam").string(), "/bin/true"},
              elsewhere)
          .wait(std::chrono::minutes(1))
          .status == 0)
    ASSERT_TRUE(run.running());
  const std::string out = start("Allclean", {}, elsewhere);
  EXPECT_FALSE(fs::exists(checkout / "results/quick"));
  EXPECT_FALSE(fs::exists(checkout / "build"));
  for (const char* stays :
       {"results/mine/summary.json", "results/noted/notes.txt", "results/noted/summary.json",
        "results/kept/previous/notes.txt", "results/running/.restenosisFoam", "results/list.txt",
        "results/mine-compare/compare.json", "results/linked", "foamCase/100",
        "foamCase/constant/triSurface/lumen.stl"})
    EXPECT_TRUE(fs::exists(checkout / stays)) << stays;
  for (const char* says :
       {"results/mine (not of a scene of the checkout)",
        "results/noted (holds notes.txt, which no run has written)",
        "results/kept (holds previous/notes.txt, ", "results/running (a run is writing there)",
        "results/list.txt (not a folder of results)", "results/linked (a link)",
        "They stay; ./Allclean --all removes them.",
        "foamCase/constant/triSurface/lumen.stl (a surface of your own"})
    EXPECT_NE(out.find(says), std::string::npos) << says << '\n' << out;
  start("Allclean", {"--all"}, elsewhere);
  EXPECT_FALSE(fs::exists(checkout / "results"));
  EXPECT_FALSE(fs::exists(checkout / "foamCase/100"));
  EXPECT_TRUE(fs::exists(elsewhere / "thesis.doc")) << "what a link names is not the checkout's";
}

TEST_F(Scripts, AllcleanTakesAChangedSceneForTheUsersOwn) {
  fs::create_directories(checkout / "scenes");
  for (const char* scene : {"quick", "changed"})
    writeText(checkout / "scenes" / (std::string(scene) + ".toml"), "[scene]\n");
  const auto git = [this](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"/usr/bin/git", "-c", "user.name=a", "-c", "user.email=a@b"});
    const ProcessEnd end = Process(arguments, checkout).wait(std::chrono::minutes(1));
    EXPECT_EQ(end.status, 0) << toString(end);
  };
  git({"init", "-q"});
  git({"add", "scenes"});
  git({"commit", "-q", "-m", "scenes"});
  writeText(checkout / "scenes/changed.toml", "[scene]\nseed = 2\n");
  writeText(checkout / "scenes/added.toml", "[scene]\n");
  for (const char* file : {"quick/summary.json", "changed/summary.json", "added/summary.json"}) result(file);
  start("Allclean", {}, elsewhere);
  EXPECT_FALSE(fs::exists(checkout / "results/quick"));
  EXPECT_TRUE(fs::exists(checkout / "results/changed"));
  EXPECT_TRUE(fs::exists(checkout / "results/added"));
}

TEST_F(Scripts, AllcleanKnowsWhatARunWrites) {
  fs::create_directories(checkout / "scenes");
  writeText(checkout / "scenes/quick.toml", with(tinyScene, "\"4 d\"", "\"4 h\""));
  for (int runs = 0; runs < 2; ++runs) {  // the second moves the first aside
    const ProcessEnd end =
        Process({RESTENOSIS_PROGRAM, "run", "scenes/quick.toml"}, checkout).wait(std::chrono::minutes(5));
    ASSERT_EQ(end.status, 0) << toString(end);
  }
  EXPECT_TRUE(fs::exists(checkout / "results/quick/previous"));
  for (const char* picture :
       {"vessel.png", "growth.png", "growth.pdf", "lumen.png", "lumen.pdf", "section.png", "section.pdf",
        "lumen3d.png", "report.html", "view.pvsm", "figures.log"})
    result("quick/" + std::string(picture));
  EXPECT_EQ(start("Allclean", {}, elsewhere), "");
  EXPECT_FALSE(fs::exists(checkout / "results"));
}

}  // namespace
}  // namespace restenosis

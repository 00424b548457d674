#include <sys/stat.h>

#include "tests/support/WholeProgram.h"

namespace restenosis {
namespace {

/// A slip, made in the tiny scene, and what the user must read about it.
struct Slip {
  const char* name;
  const char* from;
  const char* to;
  int line;  ///< of the slip in the tiny scene
  std::vector<std::string> says;
};

void PrintTo(const Slip& slip, std::ostream* out) { *out << slip.name; }

class WrongScene : public WholeProgram, public ::testing::WithParamInterface<Slip> {
 protected:
  /// Expects exit 2, one line on standard error with all of `says`, and nothing written.
  void expectRefused(const std::vector<std::string>& arguments, const std::vector<std::string>& says) {
    const ProcessEnd end = run(arguments);
    EXPECT_EXIT_STATUS(end, 2);
    EXPECT_EQ(std::ranges::count(end.err, '\n'), 1) << end.err;
    EXPECT_EQ(end.out, "");
    for (const auto& part : says) EXPECT_NE(end.err.find(part), std::string::npos) << part << '\n' << end.err;
    EXPECT_FALSE(exists("out"));
    EXPECT_FALSE(exists("results"));
  }
  /// The same of the command line's own words, after which the help follows.
  void expectHelp(const std::vector<std::string>& arguments, const std::vector<std::string>& says) {
    const ProcessEnd end = run(arguments);
    EXPECT_EXIT_STATUS(end, 2);
    for (const auto& part : says) EXPECT_NE(end.err.find(part), std::string::npos) << part << '\n' << end.err;
    EXPECT_FALSE(exists("out"));
    EXPECT_FALSE(exists("results"));
  }
};

TEST_P(WrongScene, IsRefusedWithOneClearMessage) {
  const Slip& slip = GetParam();
  const std::string file = scene("slip", with(tinyScene, slip.from, slip.to));
  auto says = slip.says;
  says.push_back("slip.toml:" + std::to_string(slip.line) + ": ");
  for (const char* command : {"run", "check"}) {
    std::vector<std::string> arguments = {command, file};
    if (arguments.front() == "run") arguments.insert(arguments.end(), {"-o", "out"});
    expectRefused(arguments, says);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Slips, WrongScene,
    ::testing::Values(
        Slip{"unknownKey", "seed = 1", "sead = 1", 5, {"unknown key 'sead'", "did you mean 'seed'?"}},
        Slip{"misspeltSection",
             "[mechanics]",
             "[mecanics]",
             25,
             {"unknown section [mecanics]", "did you mean 'mechanics'?"}},
        Slip{"wrongUnit",
             "\"0.24 mm\"",
             "\"0.24 s\"",
             9,
             {"'length' in [vessel]", "is a time", "expected a length"}},
        Slip{"noUnit", "\"0.24 mm\"", "0.24", 9, {"'length' in [vessel]", "without a unit", "\"0.24 mm\""}},
        Slip{"negativeLength",
             "\"0.24 mm\"",
             "\"-0.24 mm\"",
             9,
             {"'length' in [vessel] is -0.24 mm", "larger than 0 mm"}},
        Slip{"notANumber", "\"0.24 mm\"", "\"nan mm\"", 9, {"'length' in [vessel]", "not a finite number"}},
        Slip{"bareNotANumber",
             "seed = 1",
             "seed = nan",
             5,
             {"'seed' in [scene]", "a whole number is expected"}},
        Slip{"missingFile",
             "design = \"ring\"",
             "file = \"struts.csv\"",
             15,
             {"'file' in [stent]", "struts.csv does not exist"}},
        Slip{"openQuote", "title = \"Tiny\"", "title = \"Tiny", 2, {"not valid TOML", "closing quote"}},
        Slip{"noQuotes", "\"0.24 mm\"", "0.24 mm", 9, {"not valid TOML", "stands in quotes"}},
        Slip{"sameKeyTwice", "seed = 1", "seed = 1\nseed = 2", 6, {"not valid TOML", "'seed'"}},
        Slip{"ringLongerThanTheVessel",
             "design = \"ring\"",
             "design = \"ring\"\nlength = \"5 mm\"",
             16,
             {"a stent of 5 mm is longer than the vessel (0.24 mm)"}},
        Slip{"ringsLongerThanTheVessel",
             "design = \"ring\"",
             "design = \"rings\"\nlength = \"5 mm\"",
             16,
             {"a stent of 5 mm is longer than the vessel (0.24 mm)"}},
        Slip{"strutThickerThanTheLumen",
             "strutThickness = \"0.06 mm\"",
             "strutThickness = \"0.45 mm\"",
             17,
             {"'strutThickness' in [stent]", "0.45 mm", "lumen"}},
        Slip{"strutsBeyondTheWall",
             "\"40 um\"",
             "\"100 um\"",
             18,
             {"'deploymentDepth' in [stent]", "beyond the wall", "84 um"}},
        Slip{"zeroDuration", "\"4 d\"", "\"0 d\"", 3, {"'duration' in [scene] is 0 d", "larger than 0 d"}},
        Slip{"cellsTooLarge",
             "\"18 um\"",
             "\"50 um\"",
             12,
             {"'cellRadius' in [vessel] is 50 um", "at most 20 um", "(120 um)"}}),
    [](const auto& slip) { return std::string(slip.param.name); });

TEST_F(WrongScene, AFileThatIsNotThereIsNamedWithTheNearestOne) {
  scene("tiny", tinyScene);
  expectRefused({"run", "tinny.toml", "-o", "out"},
                {"tinny.toml: no such scene file", "did you mean tiny.toml?"});
  expectRefused({"run", ".", "-o", "out"}, {"is a folder"});
}

TEST_F(WrongScene, WhatIsNoFileIsNotRead) {
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  const std::string lumen =
      "[scene]\nduration = \"1 h\"\nstep = \"1 h\"\n[vessel]\n"
      "lumenSurface = \"FILE\"\n[flow]\n";
  for (const std::string file : {"/dev/zero", "pipe"}) {
    const std::string kind = file == "pipe" ? " is a pipe, not a file" : " is a device, not a file";
    const std::string struts =
        scene("struts", with(tinyScene, "design = \"ring\"", "file = \"" + file + "\""));
    const std::string agents =
        scene("agents", with(tinyScene, "cellRadius = \"18 um\"", "agents = \"" + file + "\""));
    const std::string surface = scene("surface", with(lumen, "FILE", file));
    for (const char* command : {"run", "check"}) {
      expectRefused({command, file}, {file + ":" + kind + "; a scene file (*.toml) is expected"});
      expectRefused({command, struts}, {"struts.toml:15: 'file' in [stent]", file + kind});
      expectRefused({command, agents}, {"agents.toml:12: 'agents' in [vessel]", file + kind});
      expectRefused({command, surface}, {"surface.toml:5: 'lumenSurface' in [vessel]", file + kind});
    }
  }
}

TEST_F(WrongScene, AFileTooLargeToBeOneIsNotRead) {
  const std::string large = scene("large", tinyScene);
  std::filesystem::resize_file(folder / large, (1 << 20) + 1);
  expectRefused({"check", large}, {"large.toml: is larger than 1 MiB, the most that is read"});
  writeText(folder / "agents.csv", "x,y,z,radius\n");
  std::filesystem::resize_file(folder / "agents.csv", std::uintmax_t{1} << 40);
  const std::string agents =
      scene("agents", with(tinyScene, "cellRadius = \"18 um\"", "agents = \"agents.csv\""));
  expectRefused({"check", agents},
                {"agents.toml:12: 'agents' in [vessel]", "agents.csv is larger than 2048 MiB"});
}

TEST_F(WrongScene, NamesNestedDeeplyAreRefusedWithTheirLine) {
  std::string deep = "a";
  for (int k = 0; k < 175'000; ++k) deep += ".a";
  for (const std::string& text :
       {"\n[" + deep + "]\n", "\n" + deep + " = 1\n", "\na = { " + deep + " = 1 }\n"})
    expectRefused({"check", scene("deep", text)}, {"deep.toml:2: a name of more than 16 parts"});
}

TEST_F(WrongScene, NothingOfASceneCommandsTheTerminal) {
  const std::string commands = "\x1b\x9b\x07\r";
  const auto expectPlain = [&](const ProcessEnd& end, std::initializer_list<std::string_view> shown) {
    const std::string text = end.out + end.err;
    EXPECT_EQ(text.find_first_of(commands), std::string::npos) << text;
    EXPECT_EQ(text.find("\u202e"), std::string::npos) << text;
    for (const auto part : shown) EXPECT_NE(text.find(part), std::string::npos) << part << '\n' << text;
  };
  const std::string title =
      scene("title", with(tinyScene, "\"Tiny\"", R"("T\u001B[2Jx\u009By\u202Ez\r\ndone")"));
  ProcessEnd end = run({"check", title});
  EXPECT_EXIT_STATUS(end, 0);
  expectPlain(end, {R"(T\x1b[2Jx\u009by\u202ez\x0d\ndone)"});
  end = run({"check", scene("key", with(tinyScene, "seed", R"("s\u001B[2Jd\u202E")"))});
  EXPECT_EXIT_STATUS(end, 2);
  expectPlain(end, {R"(unknown key 's\x1b[2Jd\u202e')"});
  end = run({"check", "none\x1b[2J\xff\n.toml"});
  EXPECT_EXIT_STATUS(end, 2);
  expectPlain(end, {R"(none\x1b[2J\xff\n.toml: no such scene file)"});
  end = run({"check", title, "--\x1b[2J"});
  EXPECT_EXIT_STATUS(end, 2);
  expectPlain(end, {R"(--\x1b[2J)"});
  writeText(folder / "lumen.stl", "solid a\x1b[2J\nfacet \x1b\n");
  end = run({"check", scene("lumen",
                            "[scene]\nduration = \"1 h\"\nstep = \"1 h\"\n[vessel]\n"
                            "lumenSurface = \"lumen.stl\"\n[flow]\n")});
  EXPECT_EXIT_STATUS(end, 2);
  expectPlain(end, {});
}

TEST_F(WrongScene, AnOverrideIsNamedAsTyped) {
  const std::string tiny = scene("tiny", tinyScene);
  expectRefused({"run", tiny, "-o", "out", "--flow", "bogus"}, {"bogus", "Allowed: foam"});
  expectRefused({"run", tiny, "-o", "out", "--set", "vessel.length=-1 mm"},
                {"--set vessel.length: ", "larger than 0 mm"});
}

TEST_F(WrongScene, AnEmptyWordIsNotADefault) {
  const std::string tiny = scene("tiny", tinyScene);
  expectRefused({"run", tiny, "-o", "out", "--flow", ""}, {"--flow: 'backend' in [flow]", "Allowed: foam"});
  expectRefused({"check", tiny, "--flow", ""}, {"--flow: 'backend' in [flow]", "Allowed: foam"});
  for (const char* command : {"run", "compare", "tradeoff"}) {
    expectHelp({command, tiny, "-o", ""}, {"--output: is empty; expected: a folder"});
    expectHelp({command, "", "-o", "out"}, {"SCENE: is empty; expected: the name of a scene file"});
  }
}

TEST_F(WrongScene, OptionsAndCommandsSayWhatIsAllowed) {
  const std::string tiny = scene("tiny", tinyScene);
  expectRefused({"rum", tiny}, {"unknown command 'rum'; did you mean 'run'? Allowed: run, check, compare"});
  for (const char* count : {"abc", "0", "1025", "1.5", "2 ", "-1", "0x2"})
    for (const char* option : {"--threads", "--ranks"})
      expectHelp({"run", tiny, "-o", "out", std::string(option) + "=" + count},
                 {std::string(option) + ": is \"" + count + "\"; a whole number from 1 to 1024 is expected"});
  expectRefused({"run", tiny, "-o", "out", "--set", "seed=2"}, {"--set seed: ", "did you mean scene.seed?"});
}

TEST_F(WrongScene, ARowOfAStentsTableThatIsThereTwiceIsNamed) {
  writeText(folder / "struts.csv", "x,y,z,radius\n0,190,120,10\n190,0,120,10\n0,190,120,10\n");
  const std::string twice = scene("twice", with(tinyScene, "design = \"ring\"", "file = \"struts.csv\""));
  expectRefused({"check", twice}, {"struts.csv:4: the agent is at the place of the one in line 2"});
}

TEST_F(WrongScene, TablesThatDoNotFitTheVesselAreNamedWithTheirLine) {
  writeText(folder / "agents.csv", "x,y,z,radius,kind\n# in mm\n0.22,0,0.12,0.018,iel\n");
  writeText(folder / "struts.csv", "x,y,z,radius\n0,190,120,10\n0,1900,120,10\n");
  const std::string wall = scene(
      "wall", with(tinyScene, "cellRadius = \"18 um\"", "cellRadius = \"18 um\"\nagents = \"agents.csv\""));
  const std::string struts = scene("struts", with(tinyScene, "design = \"ring\"", "file = \"struts.csv\""));
  for (const char* command : {"run", "check"}) {
    expectRefused({command, wall},
                  {"wall.toml:13: 'agents' in [vessel]: ", "agents.csv:3: a radius of 0.018 um"});
    expectRefused({command, struts},
                  {"struts.toml:15: 'file' in [stent]: ", "struts.csv:3: the sphere lies 1900 um"});
  }
}

TEST_F(WrongScene, UnitsThatCannotBeReadAreNamed) {
  const std::string tiny = scene("tiny", tinyScene);
  const std::vector<std::vector<std::string>> commands = {{"check", tiny}, {"run", tiny}, {"schema"}};
  for (const auto& arguments : commands) {
    const ProcessEnd end = run(arguments, {{"UDUNITS2_XML_PATH", "/nowhere.xml"}});
    EXPECT_EXIT_STATUS(end, 1);
    EXPECT_NE(end.err.find("units"), std::string::npos) << end.err;
    EXPECT_FALSE(exists("results"));
  }
}

TEST_F(WrongScene, EverySlipIsReportedAtOnce) {
  const std::string file =
      scene("slips", with(with(tinyScene, "seed = 1", "sead = 1"), "\"18 um\"", "\"18 s\""));
  const ProcessEnd end = run({"check", file});
  EXPECT_EXIT_STATUS(end, 2);
  EXPECT_EQ(std::ranges::count(end.err, '\n'), 2) << end.err;
}

TEST_F(WrongScene, AFolderOfSomethingElseIsLeftAlone) {
  std::filesystem::create_directory(folder / "out");
  writeText(folder / "out/thesis.doc", "years of work");
  const std::string tiny = scene("tiny", tinyScene);
  for (const char* command : {"run", "compare", "tradeoff"}) {
    const ProcessEnd end = run({command, tiny, "-o", "out"});
    EXPECT_EXIT_STATUS(end, 2);
    EXPECT_NE(end.err.find("thesis.doc"), std::string::npos) << end.err;
    EXPECT_EQ(contents("out").size(), 1u);
  }
}

}  // namespace
}  // namespace restenosis

#include "tests/support/WholeProgram.h"

namespace restenosis {
namespace {

namespace fs = std::filesystem;

/// The schema of scenes, as an editor applies it: by a validator that knows nothing of this program.
class JsonSchemaOfScenes : public WholeProgram {
 protected:
  static constexpr const char* python = "/usr/bin/python3";

  void SetUp() override {
    if (Process({python, "-c", "import jsonschema"}, folder.path()).wait(patience).status != 0)
      GTEST_SKIP() << "python3-jsonschema is not installed";
    const ProcessEnd end = run({"schema", "--json"});
    ASSERT_EXIT_STATUS(end, 0);
    writeText(folder / "schema.json", end.out);
    writeText(folder / "validate.py",
              "import json, jsonschema, sys, tomllib\n"
              "schema = json.load(open('schema.json'))\n"
              "jsonschema.Draft7Validator.check_schema(schema)\n"
              "scene = tomllib.load(open(sys.argv[1], 'rb'))\n"
              "wrong = [error.message for error in jsonschema.Draft7Validator(schema).iter_errors(scene)]\n"
              "print('\\n'.join(wrong))\n"
              "sys.exit(len(wrong))\n");
  }
  ProcessEnd validated(const fs::path& file) const {
    return Process({python, "validate.py", file.string()}, folder.path()).wait(patience);
  }
  void expectRefused(const std::string& text, const std::string& says) const {
    const ProcessEnd end = validated(folder / scene("wrong", text));
    EXPECT_EQ(end.status, 1) << toString(end);
    EXPECT_NE(end.out.find(says), std::string::npos) << toString(end);
  }
};

TEST_F(JsonSchemaOfScenes, EverySceneIsOne) {
  for (const auto& entry : fs::directory_iterator(fs::path(RESTENOSIS_SOURCE_DIR) / "scenes")) {
    if (entry.path().extension() != ".toml") continue;
    EXPECT_EQ(validated(entry.path()).out, "\n") << entry.path();
  }
}

/// Every key, with its default as it is written.
TEST_F(JsonSchemaOfScenes, AResolvedSceneIsOne) {
  ASSERT_EXIT_STATUS(run({"run", scene("tiny", growingScene()), "-o", "out", "--flow", "none", "--set",
                          "scene.duration=2 h"}),
                     0);
  EXPECT_EQ(validated(folder / "out/scene.toml").out, "\n");
}

TEST_F(JsonSchemaOfScenes, WhatIsWrongIsNone) {
  EXPECT_EQ(validated(folder / scene("tiny", tinyScene)).out, "\n");
  expectRefused(with(tinyScene, "strutWidth", "strutWidht"), "'strutWidht' was unexpected");
  expectRefused(with(tinyScene, "[injury]", "[injry]"), "'injry' was unexpected");
  expectRefused(with(tinyScene, "\"ring\"", "\"rnig\""), "'rnig' is not one of");
  expectRefused(with(tinyScene, "\"0.24 mm\"", "0.24"), "0.24 is not of type 'string'");
  expectRefused(with(tinyScene, "\"0.24 mm\"", "\"0.24\""), "'0.24' does not match");
  expectRefused(with(tinyScene, "length = \"0.24 mm\"\n", ""), "is not valid under any of the given schemas");
}

}  // namespace
}  // namespace restenosis

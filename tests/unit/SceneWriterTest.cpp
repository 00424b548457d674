#include <gtest/gtest.h>

#include <filesystem>

#include "bridge/scene/SceneFingerprint.h"
#include "bridge/scene/SceneReader.h"
#include "bridge/scene/SceneWriter.h"

namespace restenosis {
namespace {

TEST(SceneWriter, EveryShippedSceneIsValidAndReadsBackIdentically) {
  const Units units;
  const SceneReader reader(units);
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(RESTENOSIS_SOURCE_DIR "/scenes")) {
    if (entry.path().extension() != ".toml") continue;
    ++count;
    try {
      const Scene scene = reader.readFile(entry.path());
      const Scene again = reader.readText(writeScene(scene, units), "results/x/scene.toml");
      EXPECT_EQ(sceneValues(again), sceneValues(scene)) << entry.path();
      EXPECT_EQ(sceneFingerprint(again), sceneFingerprint(scene));
      EXPECT_EQ(writeScene(again, units).substr(writeScene(again, units).find('\n')),
                writeScene(scene, units).substr(writeScene(scene, units).find('\n')));
    } catch (const SceneError& error) {
      ADD_FAILURE() << error.what();
    }
  }
  EXPECT_GE(count, 10);
}

TEST(SceneWriter, WritesDefaultsOfModelledSectionsOnly) {
  const Units units;
  Scene scene;
  scene.scene.duration = 86400;
  scene.scene.title = "a \"quoted\" \\ title\nin two lines, 100 µm";
  scene.vessel.length = 1.2345678901234567e-3;
  scene.flow.emplace();
  const std::string text = writeScene(scene, units);
  EXPECT_NE(text.find("\nwallThickness = \"0.2 mm\""), std::string::npos) << text;
  EXPECT_NE(text.find("\n[flow]\n"), std::string::npos);
  EXPECT_EQ(text.find("[stent]"), std::string::npos);
  const Scene again = SceneReader(units).readText(text, "x.toml");
  EXPECT_EQ(again.scene.title, scene.scene.title);
  EXPECT_EQ(again.vessel.length, scene.vessel.length);
}

}  // namespace
}  // namespace restenosis

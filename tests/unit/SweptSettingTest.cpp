#include <gtest/gtest.h>

#include "bridge/scene/SweptSetting.h"

namespace restenosis {
namespace {

using Values = std::vector<std::string>;

TEST(SweptSetting, IsReadAsItIsWritten) {
  const SweptSetting swept = readSweptSetting("coupling.lumenTolerance = 1 um, 5 um,20 um");
  EXPECT_EQ(swept.key, "coupling.lumenTolerance");
  EXPECT_EQ(swept.values, (Values{"1 um", "5 um", "20 um"}));
}

TEST(SweptSetting, NeedsAKeyAndTwoValues) {
  for (const char* text :
       {"", "scene.seed", "scene.seed=", "scene.seed=1", "seed=1,2", "scene.seed=1,,2", "scene.seed=1,2,"})
    EXPECT_THROW(readSweptSetting(text), std::invalid_argument) << text;
}

TEST(SweptSetting, FollowsFromWhatTheSceneModels) {
  Scene scene;
  EXPECT_TRUE(sweptSettings(scene).empty());
  scene.mechanics.emplace();
  scene.relaxation.emplace().tolerance = 0.04;
  scene.scene.seed = 7;
  auto settings = sweptSettings(scene);
  ASSERT_EQ(settings.size(), 2u);
  EXPECT_EQ(settings[0].key, "relaxation.tolerance");
  EXPECT_EQ(settings[0].values, (Values{"0.01", "0.02", "0.04", "0.08", "0.16"}));
  EXPECT_EQ(settings[1].key, "scene.seed");
  EXPECT_EQ(settings[1].values, (Values{"7", "8", "9"}));

  scene.flow.emplace();
  scene.endothelium.emplace();
  scene.coupling.lumenTolerance = 5e-6;
  settings = sweptSettings(scene);
  ASSERT_EQ(settings.size(), 3u);
  EXPECT_EQ(settings[1].key, "coupling.lumenTolerance");
  EXPECT_EQ(settings[1].values, (Values{"1.25 um", "2.5 um", "5 um", "10 um", "20 um"}));
  scene.flow->backend = "none";
  EXPECT_EQ(sweptSettings(scene).size(), 2u);
}

}  // namespace
}  // namespace restenosis

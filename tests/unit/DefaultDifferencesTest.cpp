#include <gtest/gtest.h>

#include <algorithm>

#include "bridge/scene/DefaultDifferences.h"

namespace restenosis {
namespace {

TEST(DefaultDifferences, AreWhatTheSceneHasThatTheDefaultsHaveNot) {
  const Units units;
  Scene scene;
  scene.scene.seed = 7;
  scene.scene.duration = 2 * 86400.0;
  scene.mechanics.emplace();
  scene.flow.emplace().density = 1060;
  const auto found = defaultDifferences(scene, units);
  const auto entry = [&](std::string_view key) {
    return std::ranges::find(found, key, &DefaultDifference::key);
  };
  ASSERT_NE(entry("scene.seed"), found.end());
  EXPECT_EQ(entry("scene.seed")->value, "7");
  EXPECT_EQ(entry("scene.seed")->byDefault, "1");
  ASSERT_NE(entry("flow.density"), found.end());
  EXPECT_EQ(entry("flow.density")->value, "1060 kg/m^3");
  EXPECT_EQ(entry("flow.density")->byDefault, "1000 kg/m^3");
  EXPECT_FALSE(entry("flow.density")->meaning.empty());
  ASSERT_NE(entry("scene.duration"), found.end());
  EXPECT_EQ(entry("scene.duration")->value, "2 d");
  EXPECT_EQ(entry("flow.kinematicViscosity"), found.end()) << "as by default";
  EXPECT_TRUE(std::ranges::none_of(
      found, [](const DefaultDifference& one) { return one.key.starts_with("mechanics."); }));
}

TEST(DefaultDifferences, AreFromWhatTheFidelityStandsFor) {
  Scene scene;
  scene.scene.fidelity = "draft";
  scene.coupling = CouplingParameters::forFidelity("draft");
  scene.foam = FoamSettings::forFidelity("draft");
  scene.foam->wallLevel += 1;
  const auto found = defaultDifferences(scene, Units());
  const auto isOf = [](std::string_view section) {
    return [section](const DefaultDifference& one) { return one.key.starts_with(section); };
  };
  EXPECT_TRUE(std::ranges::none_of(found, isOf("coupling.")));
  EXPECT_EQ(std::ranges::count_if(found, isOf("foam.")), 1);
}

}  // namespace
}  // namespace restenosis

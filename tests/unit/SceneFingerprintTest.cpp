#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "bridge/scene/SceneFingerprint.h"

namespace restenosis {
namespace {

TEST(SceneFingerprint, FollowsWhatInfluencesResultsOnly) {
  Scene scene;
  const std::string reference = sceneFingerprint(scene);
  scene.name = "other", scene.scene.title = "other", scene.scene.duration = 1e6;
  scene.output.interval = 1, scene.output.pictures = false;
  EXPECT_EQ(sceneFingerprint(scene), reference);

  Scene seed, length, present, tolerance;
  seed.scene.seed = 2;
  length.vessel.length *= 1 + 1e-15;
  present.mechanics.emplace();
  tolerance.coupling.lumenTolerance *= 2;
  for (const Scene* changed : {&seed, &length, &present, &tolerance}) {
    EXPECT_NE(sceneFingerprint(*changed), reference);
  }
}

TEST(SceneFingerprint, LetsARunGoOnWithAnotherAccuracyOfTheFlow) {
  Scene scene;
  scene.flow.emplace().backend = "lbm";
  Scene fidelity = scene, foam = scene, lbm = scene, tolerance = scene, interval = scene;
  fidelity.scene.fidelity = "draft";
  tolerance.coupling.lumenTolerance *= 2;
  interval.coupling.lumenInterval = 7200;
  foam.foam.emplace();
  lbm.lbm.emplace().dx = 1e-5;
  for (const Scene* changed : {&fidelity, &foam, &lbm, &tolerance, &interval}) {
    EXPECT_NE(sceneFingerprint(*changed), sceneFingerprint(scene));
    EXPECT_EQ(checkpointFingerprint(*changed), checkpointFingerprint(scene));
    EXPECT_TRUE(lastingDifferences(scene, *changed).empty());
  }
  Scene backend = scene, schedule = scene;
  backend.flow->backend = "foam";
  schedule.coupling.schedule = "everyStep";
  for (const Scene* changed : {&backend, &schedule})
    EXPECT_NE(checkpointFingerprint(*changed), checkpointFingerprint(scene));
}

TEST(SceneFingerprint, KnowsTheSettingsOfTheFlowWhereverTheyComeFrom) {
  Scene scene;
  EXPECT_TRUE(flowSettings(scene).empty());
  scene.flow.emplace().backend = "analytic";
  const auto analytic = flowSettings(scene);
  EXPECT_EQ(analytic.size(), 2u) << "how often it is solved";
  EXPECT_TRUE(analytic.contains("coupling.lumenTolerance"));
  scene.coupling.lumenTolerance *= 2;
  EXPECT_NE(flowSettings(scene), analytic);
  for (const char* backend : {"foam", "lbm"}) {
    SCOPED_TRACE(backend);
    scene.flow->backend = backend;
    Scene given = scene, finer = scene;
    given.foam = given.foamSettings();
    given.lbm = given.lbmSettings();
    finer.scene.fidelity = "reference";
    EXPECT_FALSE(flowSettings(scene).empty());
    EXPECT_EQ(flowSettings(given), flowSettings(scene));
    EXPECT_NE(flowSettings(finer), flowSettings(scene));
  }
  Scene other = scene;
  other.foam = other.foamSettings();
  other.foam->snapIterations += 1;
  EXPECT_EQ(flowSettings(other), flowSettings(scene)) << "the backend is lbm";
}

TEST(SceneFingerprint, NamesWhatTwoScenesDifferIn) {
  Scene a, b;
  a.scene.title = "one";
  b.scene.title = "other";
  EXPECT_TRUE(lastingDifferences(a, b).empty());
  b.scene.seed = 2;
  b.vessel.length *= 2;
  b.mechanics.emplace();
  const std::vector<std::string> expected{"[mechanics]", "scene.seed", "vessel.length"};
  EXPECT_EQ(lastingDifferences(a, b), expected);
  EXPECT_EQ(lastingDifferences(b, a), expected);
}

TEST(SceneFingerprint, CountsFilesByTheirContents) {
  const auto folder = std::filesystem::path(::testing::TempDir());
  const auto first = (folder / "fingerprint1.csv").string(), second = (folder / "fingerprint2.csv").string();
  std::ofstream(first) << "1,2,3\n";
  std::ofstream(second) << "1,2,3\n";
  Scene scene;
  scene.vessel.agents = first;
  const std::string reference = sceneFingerprint(scene);
  scene.vessel.agents = second;
  EXPECT_EQ(sceneFingerprint(scene), reference);
  std::ofstream(second) << "1,2,4\n";
  EXPECT_NE(sceneFingerprint(scene), reference);
  std::filesystem::remove(first);
  std::filesystem::remove(second);
  EXPECT_THROW(sceneFingerprint(scene), std::runtime_error);
}

}  // namespace
}  // namespace restenosis

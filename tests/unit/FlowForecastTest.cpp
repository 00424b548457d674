#include <gtest/gtest.h>

#include "bridge/coupling/FlowForecast.h"
#include "tests/support/TemporaryFolder.h"

namespace restenosis {
namespace {

/// Steady flow through a tube, by Poiseuille's law.
Scene sceneWithFlow(double meanVelocity) {
  Scene scene;
  scene.vessel.lumenDiameter = 1.8e-3;
  auto& flow = scene.flow.emplace();
  flow.backend = "analytic";
  flow.meanVelocity = meanVelocity;
  flow.kinematicViscosity = 2.7e-6;
  return scene;
}

TEST(FlowForecast, SaysWhenTheFlowIsNotLaminar) {
  EXPECT_TRUE(flowForecast(sceneWithFlow(0.133), 1).empty());  // Re 89
  EXPECT_TRUE(flowForecast(sceneWithFlow(2.99), 1).empty());   // 1993
  const auto known = flowForecast(sceneWithFlow(10), 1);
  ASSERT_EQ(known.size(), 1u);
  EXPECT_TRUE(known[0].starts_with("has the Reynolds number 6667:")) << known[0];
}

TEST(FlowForecast, SaysNothingOfAFlowThatIsNeverSolved) {
  Scene scene = sceneWithFlow(10);
  scene.mechanics.emplace();
  EXPECT_NE(noFlowBecause(scene), "");
  EXPECT_TRUE(flowForecast(scene, 1).empty());
  scene.flow.reset();
  EXPECT_EQ(noFlowBecause(scene), "no [flow]");
}

TEST(FlowForecast, SaysWhatWillBeRefused) {
  Scene scene = sceneWithFlow(0.133);
  scene.flow->backend = "lbm";
  scene.lbm.emplace().dx = 1e-3;
  const auto known = flowForecast(scene, 1);
  ASSERT_EQ(known.size(), 1u);
  EXPECT_TRUE(known[0].starts_with("will be refused: 'dx' in [lbm]")) << known[0];
}

TEST(FlowForecast, SaysThatTheCaseTemplateIsMissing) {
  Scene scene = sceneWithFlow(0.133);
  scene.flow->backend = "foam";
  const std::size_t others = flowForecast(scene, 1).size();  // where OpenFOAM is missing
  const TemporaryFolder folder;
  setenv("RESTENOSIS_FOAM_CASE", folder.path().c_str(), 1);
  const auto whole = flowForecast(scene, 1);
  std::filesystem::copy(std::filesystem::path(RESTENOSIS_SOURCE_DIR) / "foamCase", folder.path(),
                        std::filesystem::copy_options::recursive);
  std::filesystem::remove_all(folder / "0.orig");
  const auto part = flowForecast(scene, 1);
  unsetenv("RESTENOSIS_FOAM_CASE");
  ASSERT_EQ(whole.size(), others + 1);
  EXPECT_EQ(whole.back(),
            "will fail: there is no whole OpenFOAM case template in " + folder.path().string() +
                " (lacks system/lumenParameters); RESTENOSIS_FOAM_CASE names the folder of another");
  ASSERT_EQ(part.size(), others + 1);
  EXPECT_NE(part.back().find("(lacks 0.orig)"), std::string::npos) << part.back();
}

TEST(FlowForecast, TheReynoldsNumberIsTheSameByEitherDrive) {
  FlowParameters flow;
  const double byVelocity = flow.reynoldsNumber(1.8e-3);
  EXPECT_NEAR(byVelocity, 0.133 * 1.8e-3 / 2.7e-6, 1e-9);
  flow.drive = "pressureGradient";
  EXPECT_NEAR(flow.reynoldsNumber(1.8e-3), byVelocity, 1e-3 * byVelocity);
  flow.drive = "resistance";
  EXPECT_NEAR(flow.reynoldsNumber(1.8e-3), byVelocity, 1e-9 * byVelocity);
  flow.distalResistance = 2 * flow.distal(1.8e-3)->resistance;
  EXPECT_NEAR(flow.reynoldsNumber(1.8e-3), byVelocity / 2, 1e-9 * byVelocity);
}

}  // namespace
}  // namespace restenosis

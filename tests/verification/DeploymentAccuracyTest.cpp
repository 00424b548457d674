#include <gtest/gtest.h>

#include <iostream>

#include "tests/support/DeploymentAccuracy.h"

namespace restenosis {
namespace {

class DeploymentAccuracy : public ::testing::TestWithParam<const char*> {};

TEST_P(DeploymentAccuracy, EndsWhereTenTimesTighterInDoublePrecisionDoes) {
  VesselParameters vessel;
  vessel.length = 0.3e-3;
  vessel.lumenDiameter = 0.6e-3;
  StentParameters stent;
  stent.deploymentDepth = 110e-6;
  stent.deploymentSteps = 30;
  stent.outerLamina = GetParam();
  const auto difference = support::differenceFromTighter(vessel, stent);
  std::cout << "EEL " << GetParam() << ": " << difference << '\n';
  EXPECT_GT(difference.rms, 0) << "the reference is no other";
  EXPECT_LT(difference.rmsOfOthers, 0.5e-6);
  EXPECT_LT(difference.branched, 0.001 * difference.agents);
  EXPECT_LT(std::abs(difference.iel), 0.5e-6);
}

INSTANTIATE_TEST_SUITE_P(Eel, DeploymentAccuracy, ::testing::Values("free", "fixed"),
                         [](const auto& outer) { return std::string(outer.param); });

}  // namespace
}  // namespace restenosis

#include <gtest/gtest.h>

#include <iostream>

#include "tests/support/DeploymentAccuracy.h"

namespace restenosis {
namespace {

/// The stent and the vessel of the scenes thesisInjury2 and, of a ring, quick.
class DeploymentAccuracyInTheThesisVessel : public ::testing::TestWithParam<const char*> {};

TEST_P(DeploymentAccuracyInTheThesisVessel, EndsWhereTenTimesTighterInDoublePrecisionDoes) {
  VesselParameters vessel;
  StentParameters stent;
  stent.design = GetParam();
  vessel.length = stent.design == "ring" ? 0.6e-3 : 4.5e-3;
  vessel.lumenDiameter = 1.8e-3;
  stent.length = 3.5e-3;
  stent.strutWidth = stent.strutThickness = 90e-6;
  stent.deploymentDepth = 110e-6;
  stent.deploymentSteps = 100;
  const auto difference = support::differenceFromTighter(vessel, stent);
  std::cout << GetParam() << ": " << difference << '\n';
  EXPECT_GT(difference.rms, 0) << "the reference is no other";
  EXPECT_LT(difference.rmsOfOthers, 0.5e-6);
  EXPECT_LT(difference.branched, 0.001 * difference.agents);
  EXPECT_LT(std::abs(difference.iel), 0.5e-6);
}

INSTANTIATE_TEST_SUITE_P(Stent, DeploymentAccuracyInTheThesisVessel, ::testing::Values("ring", "biodivysio"),
                         [](const auto& stent) { return std::string(stent.param); });

}  // namespace
}  // namespace restenosis

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "bridge/flow/lbm/LbmBackend.h"
#include "bridge/flow/lbm/SteadyLattice.h"
#include "tests/support/FlowSupport.h"
#include "tests/support/LatticeSupport.h"

namespace restenosis {
namespace {

using namespace support;

constexpr double tubeRadius = 0.5e-3, tubeLength = 0.4e-3;

LbmSettings coarse() {
  LbmSettings settings;
  settings.dx = 2.0 * tubeRadius / 16;
  return settings;
}

FlowConditions flowing(double meanVelocity) {
  FlowConditions conditions = vesselConditions();
  conditions.flowRate = meanVelocity * std::numbers::pi * tubeRadius * tubeRadius;
  return conditions;
}

double stressOf(double meanVelocity) { return 4.0 * 2.7e-3 * meanVelocity / tubeRadius; }

/// Solves, and requires either an answer near Poiseuille's or a refusal that names one of the settings.
void expectAnswerOrAdvice(const LbmSettings& settings, const FlowConditions& conditions, double expected,
                          const std::vector<std::string>& advice) {
  LbmBackend backend(settings);
  try {
    const auto s = backend.solve(tube(tubeRadius, tubeLength), conditions, {});
    const auto error = stressError(s, expected, 0.0, tubeLength);
    EXPECT_LT(std::abs(error.mean), 0.1);
    EXPECT_TRUE(std::isfinite(error.l2));
  } catch (const FlowFailed& failed) {
    bool named = false;
    for (const auto& setting : advice)
      named = named || std::string(failed.what()).find(setting) != std::string::npos;
    EXPECT_TRUE(named) << failed.what();
  }
}

std::string refusal(const TriSurface& lumen, const FlowConditions& conditions, const LbmSettings& settings) {
  try {
    LbmBackend(settings).solve(lumen, conditions, {});
  } catch (const FlowFailed& failed) {
    return failed.what();
  }
  return "";
}

TEST(LbmLimits, fastFlowOnFewNodesIsRemarkedOn) {
  const auto remarks = [](double reynolds) {
    const double velocity = reynolds * 2.7e-6 / (2.0 * tubeRadius);
    const auto s = LbmBackend(coarse()).solve(tube(tubeRadius, tubeLength), flowing(velocity), {});
    std::string text;
    for (const auto& remark : s.remarks) text += remark;
    return text;
  };
  // Twice the mean velocity on the axis, sixteen spacings across
  EXPECT_NE(remarks(90.0).find("the Reynolds number of one spacing is up to 12"), std::string::npos)
      << remarks(90.0);
  EXPECT_EQ(remarks(60.0), "");
}

TEST(LbmLimits, relaxationTimesUpToFive) {
  for (const double tau : {0.505, 0.55, 1.0, 2.0, 5.0}) {
    LatticeRelaxation relaxation;
    relaxation.tau = tau;
    const auto e = periodicTube(12, WallRule::interpolated, relaxation, 0.01);
    EXPECT_LT(e.velocity, 0.05) << tau;
    EXPECT_LT(e.stressRms, 0.1) << tau;
  }
}

TEST(LbmLimits, almostNoViscosityInTheBackend) {
  LbmSettings settings = coarse();
  settings.maximumSteps = 4000;
  // Relaxation times of 0.5005 and less, Reynolds numbers of 5,000 and more: no laminar flow to be expected
  for (const double meanVelocity : {13.0, 100.0})
    expectAnswerOrAdvice(settings, flowing(meanVelocity), stressOf(meanVelocity), {"dx", "maximumSteps"});
}

TEST(LbmLimits, latticeVelocityUpToThreeTenths) {
  for (const double velocity : {0.01, 0.1, 0.2, 0.3}) {
    LbmSettings settings = coarse();
    settings.latticeVelocity = velocity;
    expectAnswerOrAdvice(settings, flowing(0.1), stressOf(0.1), {"dx", "latticeVelocity", "maximumSteps"});
  }
}

TEST(LbmLimits, almostAtRest) {
  // The time step follows the viscosity then, not the velocity
  expectAnswerOrAdvice(coarse(), flowing(1e-9), stressOf(1e-9), {});
}

TEST(LbmLimits, gapOfAboutOneNode) {
  std::vector<ProfilePoint> throat;
  for (const auto& [r, z] :
       {std::pair(0.5, 0.0), {0.5, 0.15}, {0.055, 0.19}, {0.055, 0.21}, {0.5, 0.25}, {0.5, 0.4}})
    throat.push_back({1e-3 * r, 1e-3 * z});
  FlowConditions conditions = flowing(1e-4);
  LbmSettings settings = coarse();
  settings.maximumSteps = 20000;
  const std::string said = refusal(revolve(throat), conditions, settings);
  if (!said.empty()) {
    EXPECT_NE(said.find("dx"), std::string::npos) << said;
  }
}

TEST(LbmLimits, aLumenTooNarrowForTheSpacingIsSolvedWithAFinerOne) {
  const double radius = 0.055e-3, meanVelocity = 1e-3;
  FlowConditions conditions = vesselConditions();
  conditions.flowRate = meanVelocity * std::numbers::pi * radius * radius;
  const FlowSolution solved = LbmBackend(coarse()).solve(tube(radius, tubeLength), conditions, {});
  EXPECT_LT(solved.massImbalance, 0.05);
  EXPECT_NEAR(stressError(solved, 4 * 2.7e-3 * meanVelocity / radius, 0.0, tubeLength).mean, 0, 0.2);
  EXPECT_TRUE(std::ranges::any_of(solved.remarks, [](const std::string& remark) {
    return remark.starts_with(
        "solved with spacings of 31.25 um, for with 62.5 um, lbm.dx, it was refused: the inlet is 0.1");
  }));
}

TEST(LbmLimits, gapThinnerThanTheSpacing) {
  std::vector<ProfilePoint> throat;
  for (const auto& [r, z] :
       {std::pair(0.5, 0.0), {0.5, 0.1}, {0.002, 0.19}, {0.002, 0.21}, {0.5, 0.3}, {0.5, 0.4}})
    throat.push_back({1e-3 * r, 1e-3 * z});
  // The column of nodes on the axis passes through it; off the axis none does
  TriSurface lumen = revolve(throat);
  for (Vec3& v : lumen.vertices)
    if (v.head<2>().norm() < 0.01e-3) v.head<2>() += Eigen::Vector2d(0.02e-3, 0.02e-3);
  const std::string said = refusal(lumen, flowing(1e-4), coarse());
  EXPECT_NE(said.find("dx"), std::string::npos) << said;
}

TEST(LbmLimits, closedLumen) {
  std::vector<ProfilePoint> profile;
  for (const auto& [r, z] : {std::pair(0.5, 0.0), {0.5, 0.1}, {0.0, 0.2}, {0.5, 0.3}, {0.5, 0.4}})
    profile.push_back({1e-3 * r, 1e-3 * z});
  const std::string said = refusal(revolve(profile), flowing(0.1), coarse());
  EXPECT_FALSE(said.empty());
}

TEST(LbmLimits, numbersThatAreNone) {
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, infinity}) {
    TriSurface lumen = tube(tubeRadius, tubeLength);
    lumen.vertices[300].x() = bad;
    EXPECT_NE(refusal(lumen, flowing(0.1), coarse()), "");

    FlowConditions conditions = flowing(0.1);
    conditions.flowRate = bad;
    std::string said = refusal(tube(tubeRadius, tubeLength), conditions, coarse());
    EXPECT_NE(said.find("flow rate"), std::string::npos) << said;
    conditions = flowing(0.1);
    conditions.kinematicViscosity = bad;
    said = refusal(tube(tubeRadius, tubeLength), conditions, coarse());
    EXPECT_NE(said.find("viscosity"), std::string::npos) << said;
    conditions = flowing(0.1);
    conditions.drive = FlowConditions::Drive::pressureGradient;
    conditions.pressureGradient = bad;
    said = refusal(tube(tubeRadius, tubeLength), conditions, coarse());
    EXPECT_NE(said.find("pressure gradient"), std::string::npos) << said;
    LbmSettings settings = coarse();
    settings.dx = bad;
    EXPECT_NE(refusal(tube(tubeRadius, tubeLength), flowing(0.1), settings), "");
  }
}

TEST(LbmLimits, stepsThatDoNotSufficeAreSaidToBeTooFew) {
  LbmSettings settings = coarse();
  settings.coarseLevels = 0;
  settings.maximumSteps = 20;
  const std::string said = refusal(tube(tubeRadius, tubeLength), flowing(0.1), settings);
  EXPECT_NE(said.find("maximumSteps"), std::string::npos) << said;
  EXPECT_EQ(said.find("inf"), std::string::npos) << said;

  // As many as are allowed, also where the stress is looked at more seldom
  settings.maximumSteps = 3;
  EXPECT_NE(refusal(tube(tubeRadius, tubeLength), flowing(0.1), settings).find("within 3 steps"),
            std::string::npos);
}

TEST(LbmLimits, toleranceBelowRoundOffEnds) {
  LbmSettings settings = coarse();
  settings.precision = "float";
  settings.tolerance = 1e-14;
  settings.maximumSteps = 5000;
  expectAnswerOrAdvice(settings, flowing(0.1), stressOf(0.1), {"tolerance"});
}

TEST(LbmLimits, latticeTooLargeForMemoryIsRefusedBeforeItIsMade) {
  LbmSettings settings = coarse();
  settings.dx = 0.1e-6;
  EXPECT_NE(refusal(tube(tubeRadius, tubeLength), flowing(0.1), settings).find("dx"), std::string::npos);
}

TEST(LbmLimits, aWordThatIsNoneIsNotTakenForTheDefault) {
  for (const auto& [key, member] : {std::pair{"stress", &LbmSettings::stress},
                                    {"wall", &LbmSettings::wall},
                                    {"collision", &LbmSettings::collision},
                                    {"precision", &LbmSettings::precision}}) {
    LbmSettings settings = coarse();
    settings.*member = "othr";
    const std::string said = refusal(tube(tubeRadius, tubeLength), flowing(0.1), settings);
    EXPECT_NE(said.find(std::string("unknown lbm.") + key + " 'othr'; known: "), std::string::npos) << said;
  }
}

}  // namespace
}  // namespace restenosis

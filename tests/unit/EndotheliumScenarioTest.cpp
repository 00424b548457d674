#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include "tissue/biology/EndotheliumScenario.h"

namespace restenosis {
namespace {

double coverage(std::string_view name, double days) {
  return endotheliumScenario(name).coverage(days * 86400);
}

TEST(EndotheliumScenario, GivesTheStatedCoverage) {
  EXPECT_EQ(coverage("3-23 days", 2.999), 0.0);
  EXPECT_EQ(coverage("3-23 days", 3), 0.59);
  EXPECT_NEAR(coverage("3-23 days", 13), 0.795, 1e-12);
  EXPECT_EQ(coverage("3-23 days", 23), 1.0);
  EXPECT_EQ(coverage("3-23 days", 500), 1.0);
  EXPECT_EQ(coverage("slow linear", 0), 0.0);
  EXPECT_NEAR(coverage("slow linear", 11.5), 0.5, 1e-12);
  for (const char* name : {"fast", "normal", "slow"}) {
    EXPECT_EQ(coverage(name, 0), 0.0);
    EXPECT_NEAR(coverage(name, 1.5), 0.295, 1e-12) << name;
    EXPECT_NEAR(coverage(name, 3), 0.59, 1e-12) << name;
  }
  EXPECT_NEAR(coverage("fast", 6.5), 0.795, 1e-12);
  EXPECT_EQ(coverage("fast", 10), 1.0);
  EXPECT_EQ(coverage("normal", 15), 1.0);
  EXPECT_EQ(coverage("slow", 20), 1.0);
  EXPECT_EQ(coverage("none", 1e6), 0.0);
}

TEST(EndotheliumScenario, HasNoneBeforeItsOnset) {
  for (const auto& scenario : endotheliumScenarios()) {
    EXPECT_EQ(scenario.coverage(scenario.onset() - 1), 0.0) << scenario.name;
    if (std::isfinite(scenario.onset())) {
      EXPECT_GT(scenario.coverage(scenario.onset() + 3600), 0.0) << scenario.name;
    }
  }
}

TEST(EndotheliumScenario, NeverFalls) {
  for (const auto& scenario : endotheliumScenarios()) {
    for (int hour = 0; hour < 30 * 24; ++hour) {
      EXPECT_LE(scenario.coverage(hour * 3600.0), scenario.coverage((hour + 1) * 3600.0)) << scenario.name;
    }
  }
}

TEST(EndotheliumScenario, NamesTheScenariosThereAre) {
  try {
    endotheliumScenario("3-32 days");
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("3-23 days, slow linear"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace restenosis

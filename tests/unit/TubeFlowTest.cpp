#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bridge/flow/TubeFlow.h"

namespace restenosis {
namespace {

constexpr double radius = 0.9e-3, flowRate = 3.4e-7;
constexpr double volume = std::numbers::pi * radius * radius * radius;

/// Carreau's law with the index 1.
ViscosityLaw newtonian() {
  ViscosityLaw law;
  law.zeroShear = 2.7e-6;
  law.index = 1;
  return law;
}

/// Without the bound at rest, as the closed form has it.
ViscosityLaw casson() {
  ViscosityLaw law;
  law.kind = ViscosityLaw::Kind::casson;
  law.yieldStress = 5e-6;
  law.infiniteShear = 3.5e-6;
  law.zeroShear = 1;
  return law;
}

/// From the velocities of a flow [m^3/s].
double flowOf(const TubeFlow& flow) {
  constexpr int rings = 20000;
  double sum = 0;
  for (int n = 0; n < rings; ++n) {
    const double r = radius * (n + 0.5) / rings;
    sum += 2 * std::numbers::pi * r * flow.velocity(r) * radius / rings;
  }
  return sum;
}

TEST(TubeFlow, OfANewtonianFluidIsPoiseuilles) {
  const TubeFlow flow = TubeFlow::ofFlowRate(newtonian(), flowRate, radius);
  EXPECT_NEAR(flow.wallShearRate() * volume / (4 * flowRate), 1, 1e-6);
  EXPECT_NEAR(flow.wallStress() / (2.7e-6 * flow.wallShearRate()), 1, 1e-12);
  const double mean = flowRate / (std::numbers::pi * radius * radius);
  for (const double share : {0.0, 0.3, 0.7, 0.99})
    EXPECT_NEAR(flow.velocity(share * radius) / mean, 2 * (1 - share * share), 1e-4) << share;
  EXPECT_EQ(flow.velocity(radius), 0);
}

TEST(TubeFlow, OfAPowerLawHasItsClosedForm) {
  // Far above 1 / time, without a viscosity at infinite shear, Carreau's is a power law
  ViscosityLaw law;
  law.infiniteShear = 0;
  law.time = 1e6;
  const double n = law.index;
  const TubeFlow flow = TubeFlow::ofFlowRate(law, flowRate, radius);
  EXPECT_NEAR(flow.wallShearRate() * volume / flowRate * n / (3 * n + 1), 1, 1e-5);
  const double mean = flowRate / (std::numbers::pi * radius * radius);
  for (const double share : {0.0, 0.4, 0.8})
    EXPECT_NEAR(flow.velocity(share * radius) / mean,
                (3 * n + 1) / (n + 1) * (1 - std::pow(share, 1 / n + 1)), 1e-4)
        << share;
}

TEST(TubeFlow, OfACassonFluidHasItsClosedForm) {
  const ViscosityLaw law = casson();
  const TubeFlow flow = TubeFlow::ofFlowRate(law, flowRate, radius);
  const double x = law.yieldStress / flow.wallStress();
  const double closed = volume * flow.wallStress() / (4 * law.infiniteShear) *
                        (1 - 16.0 / 7 * std::sqrt(x) + 4.0 / 3 * x - std::pow(x, 4) / 21);
  EXPECT_NEAR(closed / flowRate, 1, 1e-5);
  // What has not reached the yield stress moves as a plug
  EXPECT_NEAR(flow.velocity(0.5 * x * radius) / flow.velocity(0), 1, 1e-4);
}

TEST(TubeFlow, CarriesWhatItWasAskedFor) {
  for (const ViscosityLaw& law : {newtonian(), ViscosityLaw(), casson()}) {
    const TubeFlow flow = TubeFlow::ofFlowRate(law, flowRate, radius);
    EXPECT_NEAR(flowOf(flow) / flowRate, 1, 1e-4);
    EXPECT_NEAR(flow.flowRate() / flowRate, 1, 1e-10);
    EXPECT_NEAR(TubeFlow::ofWallStress(law, flow.wallStress(), radius).flowRate() / flowRate, 1, 1e-9);
  }
}

TEST(ViscosityLaw, LiesBetweenItsEnds) {
  EXPECT_EQ(ViscosityLaw()(0), ViscosityLaw().zeroShear);
  EXPECT_NEAR(ViscosityLaw()(1e9) / ViscosityLaw().infiniteShear, 1, 1e-3);
  ViscosityLaw bounded = casson();
  bounded.zeroShear = 5.6e-5;
  EXPECT_EQ(bounded(0), 5.6e-5);
  EXPECT_EQ(bounded(1e-9), 5.6e-5);
  EXPECT_NEAR(bounded(1e12) / bounded.infiniteShear, 1, 1e-3);
}

}  // namespace
}  // namespace restenosis

#include <gtest/gtest.h>

#include <numbers>

#include "bridge/flow/DistalResistance.h"
#include "bridge/flow/analytic/AnalyticBackend.h"
#include "tests/support/FlowSupport.h"
#include "tests/support/TubeSurface.h"

namespace restenosis {
namespace {

using namespace support;

/// A lumen whose pressure drop is a Q + b Q^2.
class Stenosis : public FlowBackend {
 public:
  Stenosis(double linear, double square, int& solves) : linear_(linear), square_(square), solves_(solves) {}
  std::string_view name() const override { return "stenosis"; }
  FlowSolution solve(const TriSurface&, const FlowConditions& conditions,
                     const std::filesystem::path&) override {
    ++solves_;
    FlowSolution s;
    s.flowRate = conditions.flowRate;
    s.pressureDrop = (linear_ + square_ * s.flowRate) * s.flowRate;
    s.iterations = 10;
    return s;
  }

 private:
  double linear_, square_;
  int& solves_;
};

FlowConditions against(double resistance, double pressure) {
  FlowConditions c = vesselConditions();
  c.distal = DistalBed{.resistance = resistance, .pressure = pressure};
  c.flowRate = pressure / resistance;
  return c;
}

TEST(DistalResistance, LosesThePressureThatIsGiven) {
  for (const auto& [linear, square] :
       {std::pair{0.01, 0.0}, {1.0, 0.0}, {50.0, 0.0}, {0.1, 5.0}, {0.0, 1e4}}) {
    int solves = 0;
    DistalResistance backend(std::make_unique<Stenosis>(linear, square, solves));
    const auto s = backend.solve({}, against(1, 1), {});
    EXPECT_NEAR(s.flowRate + s.pressureDrop, 1, 0.01) << linear << " " << square;
    EXPECT_LE(solves, 5) << linear << " " << square;
    EXPECT_EQ(s.iterations, 10 * solves);
  }
}

TEST(DistalResistance, SolvesALumenThatResistsLittleOnce) {
  int solves = 0;
  DistalResistance backend(std::make_unique<Stenosis>(1e-3, 0, solves));
  const auto s = backend.solve({}, against(1, 1), {});
  EXPECT_EQ(solves, 1);
  EXPECT_EQ(s.flowRate, 1);
}

TEST(DistalResistance, LeavesOtherFlowsAsTheyAre) {
  int solves = 0;
  DistalResistance backend(std::make_unique<Stenosis>(1, 0, solves));
  EXPECT_EQ(backend.solve({}, vesselConditions(), {}).flowRate, vesselConditions().flowRate);
  EXPECT_EQ(solves, 1);
}

/// Two tubes and the vessels behind them in series: 8 mu L / (pi R^4) each.
TEST(DistalResistance, OfTubesInSeriesIsTheirSum) {
  const double wide = vesselRadius, narrow = 0.3 * vesselRadius, half = 2e-3;
  const auto resistance = [&](double radius) {
    return 8 * vesselConditions().dynamicViscosity() * half / (std::numbers::pi * std::pow(radius, 4));
  };
  const double tubes = resistance(wide) + resistance(narrow);
  const TriSurface lumen =
      revolve({{wide, 0}, {wide, half - 1e-9}, {narrow, half + 1e-9}, {narrow, 2 * half}});
  for (const double distal : {0.3, 1.0, 20.0}) {
    DistalResistance backend(std::make_unique<AnalyticBackend>());
    const FlowConditions conditions = against(distal * tubes, 500);
    const auto s = backend.solve(lumen, conditions, {});
    EXPECT_NEAR(s.flowRate * (1 + distal) * tubes / 500, 1, 0.01) << distal;
  }
}

}  // namespace
}  // namespace restenosis

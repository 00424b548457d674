#include <gtest/gtest.h>

#include "bridge/flow/OutletResistances.h"
#include "tests/support/FlowSupport.h"

namespace restenosis {
namespace {

/// A stem and two branches, whose pressure drops go with the flow.
class Fork : public FlowBackend {
 public:
  Fork(double stem, double first, double second, int& solves)
      : stem_(stem), first_(first), second_(second), solves_(solves) {}
  std::string_view name() const override { return "fork"; }
  FlowSolution solve(const TriSurface&, const FlowConditions& conditions,
                     const std::filesystem::path&) override {
    ++solves_;
    FlowSolution s;
    s.flowRate = conditions.flowRate;
    const double a = conditions.outlets[0].share * s.flowRate, b = conditions.outlets[1].share * s.flowRate;
    s.pressureDrop = stem_ * s.flowRate + first_ * a;
    s.outlets = {{a, 0}, {b, first_ * a - second_ * b}};
    return s;
  }

 private:
  double stem_, first_, second_;
  int& solves_;
};

FlowConditions between(double first, double second) {
  FlowConditions c = support::vesselConditions();
  c.flowRate = 2;
  c.outlets = {{.name = "a", .share = second / (first + second), .resistance = first},
               {.name = "b", .share = first / (first + second), .resistance = second}};
  return c;
}

TEST(OutletResistances, ShareOutTheFlow) {
  for (const auto& [stem, first, second] : {std::array{0.1, 0.1, 0.1}, {0.0, 1.0, 5.0}, {1.0, 0.5, 0.1}}) {
    int solves = 0;
    OutletResistances backend(std::make_unique<Fork>(stem, first, second, solves));
    const auto s = backend.solve({}, between(3, 6), {});
    // Two ways beside each other
    const double expected = 2 * (second + 6) / (first + 3 + second + 6);
    EXPECT_NEAR(s.outlets[0].flowRate / expected, 1, 0.005) << stem << " " << first << " " << second;
    EXPECT_LE(solves, 5);
  }
}

TEST(OutletResistances, SolveOnceForSharesThatAreGiven) {
  int solves = 0;
  OutletResistances backend(std::make_unique<Fork>(1, 1, 1, solves));
  FlowConditions c = between(3, 6);
  for (Outlet& outlet : c.outlets) outlet.resistance = 0;
  EXPECT_NEAR(backend.solve({}, c, {}).outlets[1].flowRate, 2.0 / 3, 1e-15);
  EXPECT_EQ(solves, 1);
}

TEST(OutletResistances, ThatAreNotFoundAreSaid) {
  int solves = 0;
  OutletResistances backend(std::make_unique<Fork>(1e6, 1e3, 1, solves));
  EXPECT_THROW(backend.solve({}, between(3, 6), {}), FlowFailed);
}

}  // namespace
}  // namespace restenosis

#include "bridge/flow/OutletResistances.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bridge/flow/RepeatedSolution.h"

namespace restenosis {
namespace {

/// How far the pressures behind the outlets may be from each other, over what is lost between the outlet with
/// the highest pressure and there, and solutions at most (both assumed: as of DistalResistance).
constexpr double agreed = 0.005;
constexpr int mostTries = 8;

/// What a solution says of the ways through the lumen to what lies behind it.
struct Ways {
  std::vector<double> shares;  ///< that go with their resistances
  double disagreement = 0;     ///< of the pressures behind, as `agreed` has it
};

Ways waysOf(const FlowSolution& solution, const std::vector<Outlet>& outlets) {
  Ways ways;
  const double highest = std::ranges::max_element(solution.outlets, {}, &OutletFlow::pressure)->pressure;
  double sum = 0, meanBehind = 0;
  std::vector<double> behind, lost;
  for (std::size_t i = 0; i < outlets.size(); ++i) {
    const auto& [flowRate, pressure] = solution.outlets[i];
    const double bed = outlets[i].resistance * flowRate;
    // Pressure that a wider outlet regains is not a resistance below none
    const double own = std::max(0.0, solution.pressureDrop - pressure) / flowRate;
    sum += ways.shares.emplace_back(1 / (own + outlets[i].resistance));
    meanBehind += behind.emplace_back(pressure - bed) / static_cast<double>(outlets.size());
    lost.push_back(highest - pressure + bed);
  }
  for (double& share : ways.shares) share /= sum;
  for (std::size_t i = 0; i < outlets.size(); ++i)
    ways.disagreement = std::max(ways.disagreement, std::abs(behind[i] - meanBehind) / lost[i]);
  return ways;
}

}  // namespace

FlowSolution OutletResistances::solve(const TriSurface& lumen, const FlowConditions& conditions,
                                      const std::filesystem::path& caseFolder) {
  const bool given =
      std::ranges::none_of(conditions.outlets, [](const Outlet& outlet) { return outlet.resistance > 0; });
  if (given) return wrapped().solve(lumen, conditions, caseFolder);
  FlowConditions tried = conditions;
  RepeatedSolution solutions(wrapped(), lumen, caseFolder);
  for (int n = 0; n < mostTries; ++n) {
    FlowSolution solution = solutions.next(tried);
    const Ways ways = waysOf(solution, tried.outlets);
    if (ways.disagreement < agreed) return solution;
    for (std::size_t i = 0; i < ways.shares.size(); ++i) tried.outlets[i].share = ways.shares[i];
  }
  throw FlowFailed(fmt::format("the flow that each outlet's resistance lets through has not been found in {} "
                               "solutions",
                               mostTries),
                   caseFolder);
}

}  // namespace restenosis

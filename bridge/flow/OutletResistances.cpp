#include "bridge/flow/OutletResistances.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace restenosis {
namespace {

/// Relative difference of each outlet's flow rate solved for and that of its resistances which is small
/// enough, and solutions at most (both assumed: as of DistalResistance).
constexpr double agreed = 0.005;
constexpr int mostTries = 8;

/// The shares that go with the resistances on the ways through the lumen and behind it.
std::vector<double> sharesFrom(const FlowSolution& solution, const std::vector<Outlet>& outlets) {
  std::vector<double> shares;
  double sum = 0;
  for (std::size_t i = 0; i < outlets.size(); ++i) {
    const double lost = solution.pressureDrop - solution.outlets[i].pressure;
    // Pressure that a wider outlet regains is not a resistance below none
    const double own = std::max(0.0, lost / solution.outlets[i].flowRate);
    sum += shares.emplace_back(1 / (own + outlets[i].resistance));
  }
  for (double& share : shares) share /= sum;
  return shares;
}

}  // namespace

FlowSolution OutletResistances::solve(const TriSurface& lumen, const FlowConditions& conditions,
                                      const std::filesystem::path& caseFolder) {
  const bool given =
      std::ranges::none_of(conditions.outlets, [](const Outlet& outlet) { return outlet.resistance > 0; });
  if (given) return wrapped().solve(lumen, conditions, caseFolder);
  FlowConditions tried = conditions;
  int iterations = 0;
  double meshSeconds = 0, solveSeconds = 0;
  for (int n = 0; n < mostTries; ++n) {
    if (n > 0 && !caseFolder.empty()) std::filesystem::remove_all(caseFolder);
    FlowSolution solution = wrapped().solve(lumen, tried, caseFolder);
    solution.iterations = iterations += solution.iterations;
    solution.meshSeconds = meshSeconds += solution.meshSeconds;
    solution.solveSeconds = solveSeconds += solution.solveSeconds;
    const std::vector<double> wanted = sharesFrom(solution, tried.outlets);
    double farthest = 0;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      farthest = std::max(farthest, std::abs(wanted[i] / tried.outlets[i].share - 1));
      tried.outlets[i].share = wanted[i];
    }
    if (farthest < agreed) return solution;
  }
  throw FlowFailed(fmt::format("the flow that each outlet's resistance lets through has not been found in {} "
                               "solutions",
                               mostTries),
                   caseFolder);
}

}  // namespace restenosis

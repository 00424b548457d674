#include "bridge/flow/DistalResistance.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "bridge/flow/RepeatedSolution.h"

namespace restenosis {
namespace {

/// Relative difference of the flow rate solved for and that of its pressure drop which is small enough
/// (assumed: of the order of a method's error).
constexpr double settled = 0.005;
/// Solutions for one lumen at most (assumed: five were enough where the drop goes with the square of the
/// flow).
constexpr int mostSolutions = 8;

/// A flow rate, and the lumen's own resistance at it.
struct Solved {
  double flowRate, resistance;
};

/// The root of Q (R_d + a + b Q) = p, with the lumen's resistance a + b Q.
double flowRateOf(const DistalBed& distal, const Solved& last, const std::optional<Solved>& before) {
  double slope = 0;
  if (before) slope = (last.resistance - before->resistance) / (last.flowRate - before->flowRate);
  if (!(slope > 0)) return distal.pressure / (distal.resistance + last.resistance);
  const double constant = distal.resistance + last.resistance - slope * last.flowRate;
  return 2 * distal.pressure / (constant + std::sqrt(constant * constant + 4 * slope * distal.pressure));
}

}  // namespace

FlowSolution DistalResistance::solve(const TriSurface& lumen, const FlowConditions& conditions,
                                     const std::filesystem::path& caseFolder) {
  if (!conditions.distal) return wrapped().solve(lumen, conditions, caseFolder);
  FlowConditions given = conditions;
  given.drive = FlowConditions::Drive::flowRate;
  given.distal.reset();
  given.beating.reset();
  std::optional<Solved> before;
  RepeatedSolution solutions(wrapped(), lumen, caseFolder);
  for (int n = 0; n < mostSolutions; ++n) {
    FlowSolution solution = solutions.next(given);
    // Pressure that a wider outlet regains is not a resistance below none
    const Solved last{given.flowRate, std::max(0.0, solution.pressureDrop / given.flowRate)};
    const double wanted = flowRateOf(*conditions.distal, last, before);
    if (std::abs(wanted / given.flowRate - 1) < settled) {
      if (!conditions.beating) return solution;
      given.beating = conditions.beating;  // about the mean that is found
      return solutions.next(given);
    }
    before = last;
    given.flowRate = wanted;
  }
  throw FlowFailed(fmt::format("the flow rate that a distal resistance of {:.3g} Pa s/m^3 lets through at "
                               "{:.4g} Pa has not been found in {} solutions",
                               conditions.distal->resistance, conditions.distal->pressure, mostSolutions),
                   caseFolder);
}

}  // namespace restenosis

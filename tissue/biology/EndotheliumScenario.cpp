#include "tissue/biology/EndotheliumScenario.h"

#include <algorithm>
#include <array>
#include <limits>

#include "tissue/parameters/NamedTable.h"
#include "tissue/parameters/SecondsPerDay.h"

namespace restenosis {

namespace {

constexpr double day = secondsPerDay;
constexpr double never = std::numeric_limits<double>::infinity();

// ISR3D gives 59 % on day 3 and all of it on the last day for fast, normal and slow; straight lines between
// are assumed.
constexpr std::array scenarios{
    EndotheliumScenario{"3-23 days", {{{3 * day, 0}, {3 * day, 0.59}, {23 * day, 1}}}, "T6"},
    EndotheliumScenario{"slow linear", {{{0, 0}, {23 * day, 1}, {23 * day, 1}}}, "T6"},
    EndotheliumScenario{"fast", {{{0, 0}, {3 * day, 0.59}, {10 * day, 1}}}, "ISR3D"},
    EndotheliumScenario{"normal", {{{0, 0}, {3 * day, 0.59}, {15 * day, 1}}}, "ISR3D"},
    EndotheliumScenario{"slow", {{{0, 0}, {3 * day, 0.59}, {20 * day, 1}}}, "ISR3D"},
    EndotheliumScenario{"none", {{{never, 0}, {never, 0}, {never, 0}}}, "assumed"},
};

}  // namespace

double EndotheliumScenario::coverage(double time) const {
  // The first point after the time
  const auto after = std::ranges::upper_bound(points, time, {}, &Point::time);
  if (after == points.begin()) return 0;
  const Point& a = *(after - 1);
  if (after == points.end()) return a.coverage;
  return a.coverage + (after->coverage - a.coverage) * (time - a.time) / (after->time - a.time);
}

std::span<const EndotheliumScenario> endotheliumScenarios() { return scenarios; }

std::vector<std::string_view> endotheliumScenarioNames() { return namesOf(scenarios); }

const EndotheliumScenario& endotheliumScenario(std::string_view name) {
  return findNamed(scenarios, "endothelium scenario", name);
}

}  // namespace restenosis

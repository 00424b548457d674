#include "tissue/biology/EndotheliumScenario.h"

#include <array>
#include <limits>

#include "tissue/parameters/NamedTable.h"
#include "tissue/parameters/SecondsPerDay.h"

namespace restenosis {

namespace {

constexpr double day = secondsPerDay;
constexpr double never = std::numeric_limits<double>::infinity();

// ISR3D gives the two ends of fast, normal and slow; nothing before day 3 and a straight line are assumed.
constexpr std::array scenarios{
    EndotheliumScenario{"3-23 days", 3 * day, 0.59, 23 * day, "T6"},
    EndotheliumScenario{"slow linear", 0, 0, 23 * day, "T6"},
    EndotheliumScenario{"fast", 3 * day, 0.59, 10 * day, "ISR3D"},
    EndotheliumScenario{"normal", 3 * day, 0.59, 15 * day, "ISR3D"},
    EndotheliumScenario{"slow", 3 * day, 0.59, 20 * day, "ISR3D"},
    EndotheliumScenario{"none", never, 0, never, "assumed"},
};

}  // namespace

double EndotheliumScenario::coverage(double time) const {
  if (time < start) return 0;
  if (time >= full) return 1;
  return startCoverage + (1 - startCoverage) * (time - start) / (full - start);
}

std::span<const EndotheliumScenario> endotheliumScenarios() { return scenarios; }

std::vector<std::string_view> endotheliumScenarioNames() { return namesOf(scenarios); }

const EndotheliumScenario& endotheliumScenario(std::string_view name) {
  return findNamed(scenarios, "endothelium scenario", name);
}

}  // namespace restenosis

#include <fmt/format.h>

#include <numbers>

#include "tissue/parameters/LengthUnits.h"
#include "tissue/parameters/Limit.h"
#include "tissue/stent/StentDesign.h"

namespace restenosis {

std::vector<StrutSegment> buildHelix(const StentParameters& stent, const StentLayout& layout) {
  std::vector<StrutSegment> segments;
  const double reach = (stent.length - stent.strutWidth) / 2, middle = layout.vesselLength / 2;
  appendLine(segments, {0, middle - reach}, {2 * std::numbers::pi * stent.helixTurns, middle + reach}, stent,
             layout);
  return segments;
}

std::vector<ParameterProblem> checkHelix(const StentParameters& stent, const VesselParameters&) {
  const double least = stent.strutWidth * (stent.helixTurns + 1);
  if (!exceeds(least, stent.length)) return {};
  return {
      {"stent.helixTurns",
       fmt::format("{:.4g} turns of a strut {:.6g} mm wide overlap on {:.6g} mm; so many need a length of "
                   "at least {} mm",
                   stent.helixTurns, stent.strutWidth / mm, stent.length / mm, shownAtLeast(least / mm)),
       {"stent.length", "stent.strutWidth"}}};
}

}  // namespace restenosis

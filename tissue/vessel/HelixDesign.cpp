#include <fmt/format.h>

#include <numbers>

#include "LengthUnits.h"
#include "StentDesign.h"

namespace restenosis {

std::vector<StrutSegment> buildHelix(const StentParameters& stent, const StentLayout& layout) {
  std::vector<StrutSegment> segments;
  const double reach = (stent.length - stent.strutWidth) / 2, middle = layout.vesselLength / 2;
  appendLine(segments, {0, middle - reach}, {2 * std::numbers::pi * stent.helixTurns, middle + reach}, stent,
             layout);
  return segments;
}

std::vector<ParameterProblem> checkHelix(const StentParameters& stent, const VesselParameters&) {
  if (stent.strutWidth * stent.helixTurns <= stent.length - stent.strutWidth) return {};
  return {
      {"stent.helixTurns",
       fmt::format("{:.4g} turns of a strut {:.4g} mm wide overlap on {:.4g} mm; so many need a length of "
                   "at least {:.4g} mm",
                   stent.helixTurns, stent.strutWidth / mm, stent.length / mm,
                   stent.strutWidth * (stent.helixTurns + 1) / mm),
       {"stent.length", "stent.strutWidth"}}};
}

}  // namespace restenosis

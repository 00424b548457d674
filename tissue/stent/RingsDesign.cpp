#include <fmt/format.h>

#include "tissue/parameters/LengthUnits.h"
#include "tissue/parameters/Limit.h"
#include "tissue/stent/StentDesign.h"

namespace restenosis {

std::vector<StrutSegment> buildRings(const StentParameters& stent, const StentLayout& layout) {
  std::vector<StrutSegment> segments;
  for (const double z : ringPlaces(stent.ringCount, stent.strutWidth / 2, stent, layout)) {
    appendRing(segments, z, 0, 0, 0, stent, layout);
  }
  return segments;
}

std::vector<ParameterProblem> checkRings(const StentParameters& stent, const VesselParameters&) {
  return checkRingsOf(stent.strutWidth, stent);
}

std::vector<ParameterProblem> checkRingsOf(double extent, const StentParameters& stent) {
  const double least = extent * static_cast<double>(stent.ringCount);
  if (!exceeds(least, stent.length)) return {};
  return {{"stent.ringCount",
           fmt::format("{} rings, each {:.6g} mm along the vessel, do not fit a stent of {:.6g} mm; so many "
                       "need a length of at least {} mm",
                       stent.ringCount, extent / mm, stent.length / mm, shownAtLeast(least / mm)),
           {"stent.length", "stent.strutWidth"}}};
}

}  // namespace restenosis

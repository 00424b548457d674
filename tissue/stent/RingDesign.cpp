#include <fmt/format.h>

#include "tissue/parameters/LengthUnits.h"
#include "tissue/parameters/Limit.h"
#include "tissue/stent/StentDesign.h"

namespace restenosis {

std::vector<StrutSegment> buildRing(const StentParameters& stent, const StentLayout& layout) {
  std::vector<StrutSegment> segments;
  appendRing(segments, layout.vesselLength / 2, 0, 0, 0, stent, layout);
  return segments;
}

std::vector<ParameterProblem> checkRing(const StentParameters& stent, const VesselParameters& vessel) {
  if (exceeds(stent.strutWidth, vessel.length)) {
    return {{"stent.strutWidth",
             fmt::format("a strut {:.6g} mm wide does not fit a vessel of {:.6g} mm; allowed is at most "
                         "vessel.length",
                         stent.strutWidth / mm, vessel.length / mm),
             {"vessel.length"}}};
  }
  // The ring itself does not use the stent's length, but a length that is given must hold.
  if (exceeds(stent.strutWidth, stent.length)) {
    return {{"stent.length",
             fmt::format("a stent of {:.6g} mm is shorter than its ring, a strut {:.6g} mm wide "
                         "(stent.strutWidth); allowed is at least that",
                         stent.length / mm, stent.strutWidth / mm),
             {"stent.strutWidth"}}};
  }
  return {};
}

}  // namespace restenosis

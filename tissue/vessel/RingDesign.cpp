#include <fmt/format.h>

#include "StentDesign.h"

namespace restenosis {
namespace {

constexpr double mm = 1e-3;

}  // namespace

std::vector<StrutSegment> buildRing(const StentParameters& stent, const StentLayout& layout) {
  std::vector<StrutSegment> segments;
  appendRing(segments, layout.vesselLength / 2, 0, 0, 0, stent, layout);
  return segments;
}

std::vector<ParameterProblem> checkRing(const StentParameters& stent, const VesselParameters& vessel) {
  if (stent.strutWidth <= vessel.length) return {};
  return {{"stent.strutWidth", fmt::format("a strut {:.4g} mm wide does not fit a vessel of {:.4g} mm",
                                           stent.strutWidth / mm, vessel.length / mm)}};
}

}  // namespace restenosis

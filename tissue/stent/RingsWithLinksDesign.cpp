#include <numbers>

#include "tissue/stent/StentDesign.h"

namespace restenosis {

std::vector<StrutSegment> buildRingsWithLinks(const StentParameters& stent, const StentLayout& layout) {
  std::vector<StrutSegment> segments = buildRings(stent, layout);
  const auto places = ringPlaces(stent.ringCount, stent.strutWidth / 2, stent, layout);
  for (std::size_t gap = 0; gap + 1 < places.size(); ++gap) {
    for (std::int64_t link = 0; link < stent.linkCount; ++link) {
      const double stagger = gap % 2 == 0 ? 0.0 : 0.5;
      const double angle =
          2 * std::numbers::pi * (static_cast<double>(link) + stagger) / static_cast<double>(stent.linkCount);
      appendLine(segments, {angle, places[gap]}, {angle, places[gap + 1]}, stent, layout);
    }
  }
  return segments;
}

}  // namespace restenosis

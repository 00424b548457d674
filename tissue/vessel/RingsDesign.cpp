#include "StentDesign.h"

namespace restenosis {

std::vector<StrutSegment> buildRings(const StentParameters& stent, const StentLayout& layout) {
  std::vector<StrutSegment> segments;
  for (const double z : ringPlaces(stent.ringCount, stent.strutWidth / 2, stent, layout)) {
    appendRing(segments, z, 0, 0, 0, stent, layout);
  }
  return segments;
}

}  // namespace restenosis

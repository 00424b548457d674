#include "StentDesign.h"

namespace restenosis {

std::vector<StrutSegment> buildRing(const StentParameters& stent, const StentLayout& layout) {
  std::vector<StrutSegment> segments;
  appendRing(segments, layout.vesselLength / 2, 0, 0, 0, stent, layout);
  return segments;
}

}  // namespace restenosis

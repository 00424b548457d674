#include <numbers>

#include "StentDesign.h"

namespace restenosis {

std::vector<StrutSegment> buildHelix(const StentParameters& stent, const StentLayout& layout) {
  std::vector<StrutSegment> segments;
  const double reach = (stent.length - stent.strutWidth) / 2, middle = layout.vesselLength / 2;
  appendLine(segments, {0, middle - reach}, {2 * std::numbers::pi * stent.helixTurns, middle + reach}, stent,
             layout);
  return segments;
}

}  // namespace restenosis

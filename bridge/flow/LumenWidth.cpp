#include "bridge/flow/LumenWidth.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "bridge/flow/LumenShape.h"

namespace restenosis {
namespace {

/// Planes that are looked at: enough of a short lumen, not too many of a long one.
constexpr double fewestPlanes = 16, mostPlanes = 4000;

double widthOf(double area, double perimeter) { return perimeter > 0.0 ? 4.0 * area / perimeter : 0.0; }

double widthOfEnd(const TriSurface& lumen, SurfaceRegion end) {
  const EndPlane plane = endPlane(lumen, end);
  return widthOf(plane.area, plane.perimeter);
}

NarrowestPlace narrowestAlongZ(const TriSurface& lumen, double spacing) {
  const double low = lumenEnd(lumen, SurfaceRegion::inlet).z;
  const double length = lumenEnd(lumen, SurfaceRegion::outlet).z - low;
  const double planes = std::clamp(std::round(length / spacing), fewestPlanes, mostPlanes);
  std::vector<double> z;
  for (double n = 0.5; n < planes; ++n) z.push_back(low + n / planes * length);
  NarrowestPlace narrowest{std::numeric_limits<double>::infinity(), std::nullopt};
  for (const CrossSection& section : crossSections(lumen, z)) {
    const double width = std::max(0.0, widthOf(section.area, section.perimeter));
    if (width < narrowest.width) narrowest = {width, section.centre.z() - low};
  }
  return narrowest;
}

}  // namespace

NarrowestPlace narrowestPlace(const TriSurface& lumen, double spacing) {
  if (liesAlongZ(lumen)) return narrowestAlongZ(lumen, spacing);
  return {std::min(widthOfEnd(lumen, SurfaceRegion::inlet), widthOfEnd(lumen, SurfaceRegion::outlet)),
          std::nullopt};
}

std::string narrownessRemark(const TriSurface& lumen, const WallPieces& pieces) {
  const NarrowestPlace narrowest = narrowestPlace(lumen, pieces.size);
  const double across = narrowest.width / pieces.size;
  if (across >= pieces.leastAcross) return "";
  const std::string place = narrowest.fromInlet
                                ? fmt::format("{:.4g} mm from the inlet", 1e3 * *narrowest.fromInlet)
                                : std::string("at an end");
  return fmt::format(
      "{} the lumen is {:.3g} um wide, {:.2g} {} of {:.4g} um: with less than {:g} the resistance and the "
      "stress there may be far off; {}",
      place, 1e6 * narrowest.width, across, pieces.name, 1e6 * pieces.size, pieces.leastAcross,
      pieces.resolvedBy);
}

}  // namespace restenosis

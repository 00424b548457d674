#include "bridge/surface/StrutSurface.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "bridge/surface/DistanceField.h"
#include "bridge/surface/Isosurface.h"

namespace restenosis {
namespace {

/// Grid spacings from the struts within which their distance is known (assumed).
constexpr double knownSpacings = 4;

/// How far the struts reach from the vessel's axis, in x or y [m].
double farthestFromAxis(std::span<const StrutSegment> struts) {
  double farthest = 0;
  for (const StrutSegment& s : struts)
    farthest = std::max(farthest, s.a.head<2>().cwiseAbs().cwiseMax(s.b.head<2>().cwiseAbs()).maxCoeff() +
                                      std::hypot(s.width, s.thickness) + s.overlap);
  return farthest;
}

}  // namespace

TriSurface strutSurface(std::span<const StrutSegment> struts, double length, double resolution) {
  if (struts.empty()) return {};
  const LumenGrid grid(length, farthestFromAxis(struts) + knownSpacings * resolution, resolution);
  const BandField outside = strutBand(grid, struts, knownSpacings * resolution);
  const BandField inside(grid, [&](int k, float* plane) {
    for (int j = 0; j < grid.ny; ++j) {
      float* row = plane + grid.row(j, 0);
      outside.copyRow(j, k, row);
      std::transform(row, row + grid.nx, row, std::negate<>());
    }
  });
  TriSurface surface = isosurface(inside);
  std::ranges::fill(surface.region, SurfaceRegion::strut);
  return surface;
}

}  // namespace restenosis

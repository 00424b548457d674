#pragma once

#include <array>
#include <string>
#include <vector>

#include "bridge/surface/TriSurface.h"

namespace restenosis {

/// What `checkSurface` found; a surface without violations may be given to a flow solver.
struct SurfaceReport {
  std::vector<std::string> violations;  ///< one sentence each, at most one of a kind
  double volume = 0;                    ///< enclosed [m^3]
  std::array<double, 4> area{};         ///< by SurfaceRegion [m^2]
  std::size_t components = 0;           ///< connected pieces of the surface
  double areaOf(SurfaceRegion r) const { return area[static_cast<std::size_t>(r)]; }
  bool good() const { return violations.empty(); }
  /// All violations in one line, for messages.
  std::string summary() const;
};

/// Checks a lumen surface: finite; every edge shared by exactly two triangles that run along it in opposite
/// directions; no degenerate triangle (height below 1e-4 of its longest side, wall and strut only: caps are
/// planes and may be cut as they like); oriented outwards (positive volume); one lumen, its only further
/// pieces being floating struts, which enclose negative volume; inlet and outlet planar, perpendicular to the
/// axis at z = 0 and z = `length` [m] to round-off, with area.
SurfaceReport checkSurface(const TriSurface& surface, double length);

}  // namespace restenosis

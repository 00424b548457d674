#pragma once

#include <vector>

#include "AgentStore.h"

namespace restenosis {

/// A straight piece of a strut: a box (or a cylinder) swept from `a` to `b`. Struts of every design are
/// chains of these, so mechanics (obstacle agents) and flow (lumen surface) see one shape.
struct StrutSegment {
  Vec3 a, b;         ///< ends of the centreline [m]
  Vec3 radial;       ///< unit vector along the strut's thickness, away from the vessel's axis
  double width;      ///< extent along the surface, across the centreline [m]
  double thickness;  ///< extent along `radial` [m]
  bool round;        ///< elliptic instead of rectangular cross-section
};

/// Signed distance from a point to a strut segment [m], negative inside. Exact for boxes outside; ends are
/// flat and overlap at joints by half a width, so that a chain has no notches.
double signedDistance(const StrutSegment& segment, const Vec3& point);

}  // namespace restenosis

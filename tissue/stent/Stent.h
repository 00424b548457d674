#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "tissue/agents/AgentStore.h"

namespace restenosis {

/// A straight segment of a strut: a box (or a cylinder) swept from `a` to `b`. Struts of every design are
/// chains of these, so mechanics (obstacle agents) and flow (lumen surface) share one shape.
/// A round segment with a == b is a sphere (struts loaded from a table).
struct StrutSegment {
  Vec3 a, b;           ///< ends of the centreline [m]
  Vec3 radial;         ///< unit vector along the strut's thickness, away from the vessel's axis
  double width;        ///< extent along the surface, across the centreline [m]
  double thickness;    ///< extent along `radial` [m]
  bool round;          ///< elliptic instead of rectangular cross-section
  double overlap = 0;  ///< the flat ends lie this far beyond a and b, so that a chain has no notches [m]
  bool openA = true;   ///< whether the strut ends at a; where it continues, the end is no surface
  bool openB = true;   ///< the same at b

  double length() const { return (b - a).norm(); }
};

/// Signed distance from points to a strut segment [m], negative inside. Exact for boxes and for circular
/// sections; for elliptic sections accurate to first order near the surface. Inside, an end where the strut
/// continues does not count, so that the least distance over a chain's segments is that of the chain, without
/// dips at its joints.
class StrutDistance {
 public:
  explicit StrutDistance(const StrutSegment& segment);
  double operator()(const Vec3& point) const;

 private:
  Vec3 middle_, along_, across_, radial_;
  double halfLength_, halfWidth_, halfThickness_;  ///< half the length with its overlap
  bool sphere_, round_, openA_, openB_;
};

/// An obstacle sphere of a strut, in the coordinates of its segment, so that it follows the segment.
struct StrutSphere {
  std::size_t segment;
  double along;    ///< place between a (0) and b (1)
  double across;   ///< from the centreline, along the vessel's surface [m]
  double outward;  ///< from the centreline, away from the axis [m]
  double radius;   ///< [m]
};

/// A stent: its shape and the obstacle spheres that stand for it in the mechanics.
struct Stent {
  std::vector<StrutSegment> segments;
  std::vector<StrutSphere> spheres;

  /// Centre of spheres[n] [m]. Here segments are bent around the axis, so that the spheres of a ring lie on
  /// circles.
  Vec3 centre(std::size_t n) const;
  /// Places on the centrelines, 20 um apart or less [m].
  std::vector<Vec3> middles() const;
  /// The same stent with every centreline moved away from the axis by `distance` [m].
  Stent movedOutwards(double distance) const;
};

}  // namespace restenosis

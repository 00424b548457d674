#pragma once

#include <memory>
#include <vector>

#include "bridge/surface/PointTree.h"
#include "bridge/surface/TriSurface.h"

namespace restenosis {

/// The axis of a bent vessel, with a frame along it that turns about it as little as it can
/// (rotation-minimising; Wang et al. 2008, ACM Trans Graph 27:2). It takes the straight vessel, whose axis is
/// z, to the bent one and back: a point (x, y, z) of the straight vessel lies at the place z along the axis,
/// x and y across it. Beyond its ends the axis goes straight on. All lengths in m.
class Centreline {
 public:
  /// A smooth curve through points in order (a cubic spline). At least two; throws std::invalid_argument for
  /// fewer, or for neighbours in one place. The frame at its beginning is that of a straight vessel along z,
  /// turned onto the curve the short way.
  static Centreline through(const std::vector<Vec3>& points);
  /// An arc in the plane x = 0 that passes through the origin along z, its place 0, and bends towards y; from
  /// one place to another.
  static Centreline arc(double radius, double from, double to);

  double length() const { return places_.back() - places_.front(); }
  /// The largest curvature along it [1/m].
  double largestCurvature() const;
  struct Frame {
    Vec3 origin, x, y, z;
  };
  /// At a place along the axis.
  Frame at(double place) const;
  Vec3 toBent(const Vec3& straight) const;
  /// Of a point nearer to the axis than its radius of curvature.
  Vec3 toStraight(const Vec3& bent) const;
  /// A vector at a point of the straight vessel.
  Vec3 vectorToBent(const Vec3& straight, const Vec3& vector) const;
  /// The same back; `straight` is where the point is in the straight vessel.
  Vec3 vectorToStraight(const Vec3& straight, const Vec3& vector) const;

 private:
  /// Closely spaced points on the curve and its unit tangents there.
  Centreline(std::vector<Vec3> points, std::vector<Vec3> tangents, double firstPlace);

  std::vector<double> places_;
  std::vector<Frame> frames_;
  std::shared_ptr<const PointTree> tree_;
};

}  // namespace restenosis

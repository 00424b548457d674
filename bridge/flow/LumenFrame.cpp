#include "bridge/flow/LumenFrame.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "bridge/flow/LumenShape.h"
#include "bridge/surface/Rotation.h"

namespace restenosis {
namespace {

/// How far the ends may be from parallel.
constexpr double parallelWithin = 0.1 * std::numbers::pi / 180;

Eigen::Isometry3d frameFrom(const Vec3& axis, const Vec3& origin) {
  const Eigen::Matrix3d turn = rotationOnto(axis, Vec3::UnitZ());
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
  frame.linear() = turn;
  frame.translation() = -(turn * origin);
  return frame;
}

TriSurface moved(const TriSurface& lumen, const Eigen::Isometry3d& frame) {
  TriSurface result = lumen;
  for (Vec3& v : result.vertices) v = frame * v;
  return result;
}

/// Puts the vertices of an end into the plane of constant z through its centre.
void flatten(TriSurface& lumen, SurfaceRegion end) {
  Vec3 centre = Vec3::Zero();
  double area = 0.0;
  for (std::size_t t = 0; t < lumen.triangles.size(); ++t)
    if (lumen.region[t] == end) {
      const double own = lumen.areaVector(t).norm();
      centre += own * lumen.centre(t);
      area += own;
    }
  for (std::size_t t = 0; t < lumen.triangles.size(); ++t)
    if (lumen.region[t] == end)
      for (const auto v : lumen.triangles[t]) lumen.vertices[v].z() = centre.z() / area;
}

}  // namespace

std::optional<Eigen::Isometry3d> frameAlongZ(const TriSurface& lumen) {
  if (lumen.outletCount() > 1) return std::nullopt;
  const EndPlane inlet = endPlane(lumen, SurfaceRegion::inlet);
  const EndPlane outlet = endPlane(lumen, SurfaceRegion::outlet);
  if (inlet.normal.cross(outlet.normal).norm() > std::sin(parallelWithin) ||
      inlet.normal.dot(outlet.normal) > 0.0)
    return std::nullopt;
  const Eigen::Isometry3d frame = frameFrom((outlet.normal - inlet.normal).normalized(), inlet.centre);
  if (!liesAlongZ(movedAlongZ(lumen, frame))) return std::nullopt;
  return frame;
}

TriSurface movedAlongZ(const TriSurface& lumen, const Eigen::Isometry3d& frame) {
  TriSurface result = moved(lumen, frame);
  flatten(result, SurfaceRegion::inlet);
  flatten(result, SurfaceRegion::outlet);
  return result;
}

Eigen::Isometry3d frameOfInlet(const TriSurface& lumen) {
  const EndPlane inlet = endPlane(lumen, SurfaceRegion::inlet);
  return frameFrom(-inlet.normal, inlet.centre);
}

LaidLumen laidLumen(const TriSurface& lumen) {
  requireLumenWithPlanarEnds(lumen);
  if (const auto along = frameAlongZ(lumen)) return {movedAlongZ(lumen, *along), *along};
  const Eigen::Isometry3d frame = frameOfInlet(lumen);
  LaidLumen laid{moved(lumen, frame), frame};
  flatten(laid.surface, SurfaceRegion::inlet);
  return laid;
}

FlowSolution AnyDirection::solve(const TriSurface& lumen, const FlowConditions& conditions,
                                 const std::filesystem::path& caseFolder) {
  LaidLumen laid;
  try {
    laid = laidLumen(lumen);
  } catch (const std::invalid_argument& error) {
    throw FlowFailed(error.what(), {});
  }
  frame_ = laid.frame;
  FlowSolution solution = backend_->solve(laid.surface, conditions, caseFolder);
  const Eigen::Isometry3d back = frame_.inverse();
  for (WallFace& face : solution.wall) {
    face.centre = back * face.centre;
    face.traction = back.linear() * face.traction;
    face.beat.mean = back.linear() * face.beat.mean;
  }
  return solution;
}

std::vector<Vec3> AnyDirection::velocities(const std::vector<Vec3>& points) const {
  std::vector<Vec3> moved;
  for (const Vec3& p : points) moved.push_back(frame_ * p);
  std::vector<Vec3> result = backend_->velocities(moved);
  for (Vec3& u : result) u = frame_.linear().transpose() * u;
  return result;
}

}  // namespace restenosis

#include "bridge/flow/BentVessel.h"

#include "bridge/surface/VesselAxis.h"

namespace restenosis {

FlowSolution BentVessel::solve(const TriSurface& lumen, const FlowConditions& conditions,
                               const std::filesystem::path& caseFolder) {
  FlowSolution solution = wrapped().solve(bentAlong(*axis_, lumen), conditions, caseFolder);
  for (WallFace& face : solution.wall) {
    face.centre = axis_->toStraight(face.centre);
    face.traction = axis_->vectorToStraight(face.centre, face.traction);
    face.beat.mean = axis_->vectorToStraight(face.centre, face.beat.mean);
  }
  return solution;
}

std::vector<Vec3> BentVessel::velocities(const std::vector<Vec3>& points) const {
  std::vector<Vec3> bent;
  for (const Vec3& point : points) bent.push_back(axis_->toBent(point));
  std::vector<Vec3> result = WrappedBackend::velocities(bent);
  for (std::size_t n = 0; n < result.size(); ++n) result[n] = axis_->vectorToStraight(points[n], result[n]);
  return result;
}

}  // namespace restenosis

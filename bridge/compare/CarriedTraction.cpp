#include "bridge/compare/CarriedTraction.h"

#include <limits>

#include "bridge/flow/RegionalFaces.h"

namespace restenosis {
namespace {

constexpr std::size_t neighbours = 4;
/// Faces nearer than this are the triangle itself [m].
constexpr double same = 1e-9;

Vec3 meanOf(const std::vector<RegionalFaces::Near>& near) {
  if (near.empty()) return Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
  if (near.front().distance < same) return near.front().face->traction;
  Vec3 sum = Vec3::Zero();
  double weights = 0.0;
  for (const auto& n : near) {
    const double weight = 1.0 / (n.distance * n.distance);
    sum += weight * n.face->traction;
    weights += weight;
  }
  return sum / weights;
}

}  // namespace

std::vector<Vec3> carriedTraction(const TriSurface& lumen, const ComparedFaces& faces,
                                  const FlowSolution& flow) {
  const RegionalFaces flowFaces(flow.wall);
  std::vector<Vec3> result(faces.size());
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const std::size_t t = faces.triangle[i];
    result[i] = meanOf(flowFaces.nearest(lumen.centre(t), lumen.region[t], neighbours));
  }
  return result;
}

}  // namespace restenosis

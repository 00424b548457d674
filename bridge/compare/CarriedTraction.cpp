#include "CarriedTraction.h"

#include <limits>

#include "PointTree.h"

namespace restenosis {
namespace {

constexpr std::size_t neighbours = 4;
/// Faces nearer than this are the triangle itself [m].
constexpr double same = 1e-9;

struct FacesOfRegion {
  FacesOfRegion(const FlowSolution& flow, SurfaceRegion region) : tree(centres(flow, region)) {
    for (const WallFace& f : flow.wall)
      if (f.region == region) traction.push_back(f.traction);
  }
  static std::vector<Vec3> centres(const FlowSolution& flow, SurfaceRegion region) {
    std::vector<Vec3> result;
    for (const WallFace& f : flow.wall)
      if (f.region == region) result.push_back(f.centre);
    return result;
  }
  Vec3 at(const Vec3& place) const {
    const auto near = tree.nearest(place, neighbours);
    if (near.empty()) return Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
    if (near.front().distance < same) return traction[near.front().index];
    Vec3 sum = Vec3::Zero();
    double weights = 0.0;
    for (const auto& n : near) {
      const double weight = 1.0 / (n.distance * n.distance);
      sum += weight * traction[n.index];
      weights += weight;
    }
    return sum / weights;
  }
  PointTree tree;
  std::vector<Vec3> traction;
};

}  // namespace

std::vector<Vec3> carriedTraction(const TriSurface& lumen, const ComparedFaces& faces,
                                  const FlowSolution& flow) {
  const FacesOfRegion wall(flow, SurfaceRegion::wall), strut(flow, SurfaceRegion::strut);
  std::vector<Vec3> result(faces.size());
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const std::size_t t = faces.triangle[i];
    result[i] = (lumen.region[t] == SurfaceRegion::strut ? strut : wall).at(lumen.centre(t));
  }
  return result;
}

}  // namespace restenosis

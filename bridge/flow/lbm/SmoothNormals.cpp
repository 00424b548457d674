#include "bridge/flow/lbm/SmoothNormals.h"

#include <numeric>

namespace restenosis {
namespace {

/// Faces that meet at a larger angle than 45 degrees do not smooth each other's normals.
constexpr double creaseCosine = 0.7071;

}  // namespace

template <class F>
void SmoothNormals::forEachCorner(F&& f) const {
  for (std::uint32_t i = 0; i < surface_.triangles.size(); ++i) {
    if (surface_.region[i] != SurfaceRegion::wall && surface_.region[i] != SurfaceRegion::strut) continue;
    for (const auto v : surface_.triangles[i]) f(v, i);
  }
}

SmoothNormals::SmoothNormals(const TriSurface& surface)
    : surface_(surface), first_(surface.vertices.size() + 1, 0) {
  forEachCorner([this](std::uint32_t vertex, std::uint32_t) { ++first_[vertex + 1]; });
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  faces_.resize(first_.back());
  auto next = first_;
  forEachCorner([&](std::uint32_t vertex, std::uint32_t face) { faces_[next[vertex]++] = face; });
}

Vec3 SmoothNormals::at(std::size_t face) const {
  const Vec3 own = surface_.areaVector(face).normalized();
  Vec3 sum = Vec3::Zero();
  for (const auto v : surface_.triangles[face])
    for (std::uint32_t k = first_[v]; k < first_[v + 1]; ++k) {
      const Vec3 other = surface_.areaVector(faces_[k]);
      if (other.dot(own) > creaseCosine * other.norm()) sum += other;
    }
  return sum.normalized();
}

}  // namespace restenosis

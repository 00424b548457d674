#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include "bridge/surface/SurfaceEnds.h"
#include "bridge/surface/TriSurface.h"

namespace restenosis {

/// How far an end may be from a plane, over its diameter (assumed); it is made planar.
constexpr double lumenEndPlanarity = 0.02;

/// How many outlets a lumen may have. Several are solids of their own, and so is the inlet.
enum class Outlets { one, several };

/// One end of a loaded lumen: its triangles, and which it is where a solid's name says so.
struct LumenCap {
  std::vector<std::uint32_t> triangles;
  std::optional<SurfaceRegion> named;
  std::string solid = {};  ///< name of an outlet's, where there may be several

  /// Sum over its triangles [m^2].
  Vec3 areaVector(const TriSurface& s) const {
    return std::accumulate(triangles.begin(), triangles.end(), Vec3(Vec3::Zero()),
                           [&](const Vec3& sum, std::uint32_t t) { return Vec3(sum + s.areaVector(t)); });
  }
  /// Of the circle of its area [m].
  double diameter(const TriSurface& s) const {
    return 2.0 * std::sqrt(areaVector(s).norm() / std::numbers::pi);
  }
  /// In ascending order, each once.
  std::vector<std::uint32_t> vertices(const TriSurface& s) const {
    std::vector<std::uint32_t> all;
    for (const auto t : triangles) all.insert(all.end(), s.triangles[t].begin(), s.triangles[t].end());
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
  }
  /// Mean of its vertices [m].
  Vec3 centre(const TriSurface& s) const { return fitPlane(s, vertices(s)).centre; }
};

}  // namespace restenosis

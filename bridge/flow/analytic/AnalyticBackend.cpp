#include "AnalyticBackend.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "FlowBackendNames.h"
#include "LumenShape.h"
#include "TrianglePieces.h"

namespace restenosis {
namespace {

using std::numbers::pi;

/// Longest piece of a triangle that gets a stress of its own, over the mean radius (assumed).
constexpr double longestPiece = 0.25;

/// Radius of the circle with the cross-section's area, along the vessel.
class RadiusProfile {
 public:
  RadiusProfile(const TriSurface& lumen, int stations) {
    const double inlet = lumenEnd(lumen, SurfaceRegion::inlet).z;
    const double length = lumenEnd(lumen, SurfaceRegion::outlet).z - inlet;
    spacing_ = length / stations;
    first_ = inlet + 0.5 * spacing_;
    std::vector<double> z(stations);
    for (int i = 0; i < stations; ++i) z[i] = first_ + i * spacing_;
    const auto areas = crossSectionAreas(lumen, z);
    for (int i = 0; i < stations; ++i) {
      if (!(areas[i] > 0.0))
        throw FlowFailed(fmt::format("analytic flow: the lumen is closed at z = {:.4g} mm", z[i] * 1e3), {});
      radii_.push_back(std::sqrt(areas[i] / pi));
    }
  }
  double operator()(double z) const {
    const double last = static_cast<double>(radii_.size() - 1);
    const double x = std::clamp((z - first_) / spacing_, 0.0, last);
    const auto i = std::min(static_cast<std::size_t>(x), radii_.size() - 2);
    const double f = x - static_cast<double>(i);
    return (1.0 - f) * radii_[i] + f * radii_[i + 1];
  }
  double meanRadius() const {
    return std::accumulate(radii_.begin(), radii_.end(), 0.0) / static_cast<double>(radii_.size());
  }
  double length() const { return spacing_ * static_cast<double>(radii_.size()); }
  /// Pressure lost along the lumen for a unit flow rate [Pa s/m^3].
  double resistance(double viscosity) const {
    double sum = 0.0;
    for (const double radius : radii_) sum += spacing_ * 8.0 * viscosity / (pi * std::pow(radius, 4));
    return sum;
  }

 private:
  double first_ = 0.0, spacing_ = 0.0;
  std::vector<double> radii_;
};

/// The direction of the axis in a face's plane; zero for a face across the axis.
Vec3 alongAxis(const Vec3& unitNormal) {
  const Vec3 tangent = Vec3::UnitZ() - unitNormal.z() * unitNormal;
  const double length = tangent.norm();
  return length > 1e-9 ? Vec3(tangent / length) : Vec3(Vec3::Zero());
}

}  // namespace

std::string_view AnalyticBackend::name() const { return flowBackendNames::analytic; }

FlowSolution AnalyticBackend::solve(const TriSurface& lumen, const FlowConditions& conditions,
                                    const std::filesystem::path&) {
  try {
    requireLumen(lumen);
  } catch (const std::invalid_argument& error) {
    throw FlowFailed(fmt::format("analytic flow: {}", error.what()), {});
  }
  const RadiusProfile profile(lumen, stations_);
  const double mu = conditions.dynamicViscosity();
  const double resistance = profile.resistance(mu);
  // What flows in flows out: one flow rate for all cross-sections, whatever drives it
  const double flowRate = conditions.drive == FlowConditions::Drive::flowRate
                              ? conditions.flowRate
                              : conditions.pressureGradient * profile.length() / resistance;

  FlowSolution solution;
  for (std::size_t i = 0; i < lumen.triangles.size(); ++i) {
    if (lumen.region[i] != SurfaceRegion::wall && lumen.region[i] != SurfaceRegion::strut) continue;
    const Vec3 areaVector = lumen.areaVector(i);
    const double area = areaVector.norm();
    if (!(area > 0.0)) continue;
    const Vec3 direction = alongAxis(areaVector / area);
    const auto& [a, b, c] = lumen.triangles[i];
    forEachPieceOf({lumen.vertices[a], lumen.vertices[b], lumen.vertices[c]},
                   longestPiece * profile.meanRadius(), [&](const Vec3& centre, double pieceArea) {
                     const double radius = profile(centre.z());
                     const double stress = 4.0 * mu * flowRate / (pi * radius * radius * radius);
                     solution.wall.push_back({centre, pieceArea, stress * direction, lumen.region[i]});
                   });
  }
  solution.pressureDrop = flowRate * resistance;
  return solution;
}

}  // namespace restenosis

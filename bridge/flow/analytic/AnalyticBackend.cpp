#include "bridge/flow/analytic/AnalyticBackend.h"

#include <fmt/format.h>

#include <numbers>

#include "bridge/flow/FlowBackendNames.h"
#include "bridge/flow/LumenShape.h"
#include "bridge/flow/TrianglePieces.h"
#include "bridge/flow/analytic/LumenProfile.h"

namespace restenosis {
namespace {

using std::numbers::pi;

/// Longest piece of a triangle that gets a stress of its own, over the mean radius (assumed).
constexpr double longestPiece = 0.25;

/// The direction of the axis in a face's plane; zero for a face across the axis.
Vec3 alongAxis(const Vec3& axis, const Vec3& unitNormal) {
  const Vec3 tangent = axis - axis.dot(unitNormal) * unitNormal;
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
  const LumenProfile profile(lumen, stations_);
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
    const Vec3 normal = areaVector / area;
    const auto& [a, b, c] = lumen.triangles[i];
    forEachPieceOf(
        {lumen.vertices[a], lumen.vertices[b], lumen.vertices[c]}, longestPiece * profile.meanRadius(),
        [&](const Vec3& centre, double pieceArea) {
          const auto [radius, axis] = profile.at(centre.z());
          const double stress = 4.0 * mu * flowRate / (pi * radius * radius * radius);
          solution.wall.push_back({centre, pieceArea, stress * alongAxis(axis, normal), lumen.region[i]});
        });
  }
  solution.flowRate = flowRate;
  solution.pressureDrop = flowRate * resistance;
  return solution;
}

}  // namespace restenosis

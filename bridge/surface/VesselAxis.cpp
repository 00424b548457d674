#include "bridge/surface/VesselAxis.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "bridge/surface/CentrelineFile.h"
#include "bridge/surface/CylinderSurface.h"
#include "bridge/surface/LengthUnit.h"
#include "bridge/surface/LoadedLumen.h"
#include "bridge/surface/SectionAxis.h"

namespace restenosis {
namespace {

CentrelinePoints pointsOf(const VesselParameters& vessel) {
  return readCentreline(vessel.centreline, metresPer(vessel.centrelineUnit));
}

/// How far along the chords each point lies, as a share of all.
std::vector<double> sharesAlong(const std::vector<Vec3>& points) {
  std::vector<double> shares{0};
  for (std::size_t n = 1; n < points.size(); ++n)
    shares.push_back(shares.back() + (points[n] - points[n - 1]).norm());
  for (double& share : shares) share /= shares.back();
  return shares;
}

}  // namespace

std::shared_ptr<const Centreline> vesselAxis(const VesselParameters& vessel, double beyond) {
  if (!vessel.isBent()) return nullptr;
  if (vessel.lumenSurfaceIsBent) return std::make_shared<const Centreline>(axisBySections(loadLumen(vessel)));
  if (!vessel.centreline.empty())
    return std::make_shared<const Centreline>(Centreline::through(pointsOf(vessel).points));
  return std::make_shared<const Centreline>(
      Centreline::arc(vessel.curvatureRadius, -beyond, vessel.length + beyond));
}

double sharpestRadius(const VesselParameters& vessel) {
  if (vessel.centreline.empty() && !vessel.lumenSurfaceIsBent)
    return vessel.isBent() ? vessel.curvatureRadius : std::numeric_limits<double>::infinity();
  const double curvature = vesselAxis(vessel)->largestCurvature();
  return curvature > 0 ? 1 / curvature : std::numeric_limits<double>::infinity();
}

bool hasRadiiAlong(const VesselParameters& vessel) {
  return !vessel.centreline.empty() && !pointsOf(vessel).radii.empty();
}

std::function<double(double)> lumenRadius(const VesselParameters& vessel) {
  if (!hasRadiiAlong(vessel)) return [vessel](double z) { return cylinderRadius(vessel, z); };
  const CentrelinePoints centreline = pointsOf(vessel);
  return
      [radii = centreline.radii, shares = sharesAlong(centreline.points), length = vessel.length](double z) {
        const double share = std::clamp(z / length, 0.0, 1.0);
        const auto next = std::min<std::size_t>(
            shares.size() - 1,
            static_cast<std::size_t>(std::ranges::upper_bound(shares, share) - shares.begin()));
        const double part = (share - shares[next - 1]) / (shares[next] - shares[next - 1]);
        return radii[next - 1] + part * (radii[next] - radii[next - 1]);
      };
}

TriSurface straightLumen(const VesselParameters& vessel) {
  TriSurface surface = cylinderSurface(vessel);
  if (!hasRadiiAlong(vessel)) return surface;
  const auto radius = lumenRadius(vessel);
  for (Vec3& vertex : surface.vertices) {
    const double factor = radius(vertex.z()) / cylinderRadius(vessel, vertex.z());
    vertex.x() *= factor, vertex.y() *= factor;
  }
  return surface;
}

TriSurface bentAlong(const Centreline& axis, const TriSurface& straight) {
  TriSurface bent = straight;
  for (Vec3& vertex : bent.vertices) vertex = axis.toBent(vertex);
  return bent;
}

}  // namespace restenosis

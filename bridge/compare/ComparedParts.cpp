#include "bridge/compare/ComparedParts.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bridge/flow/LumenShape.h"
#include "bridge/surface/PointTree.h"

namespace restenosis {

std::string_view partName(ComparedPart part) {
  switch (part) {
    case ComparedPart::smoothWall:
      return "smoothWall";
    case ComparedPart::betweenStruts:
      return "betweenStruts";
    case ComparedPart::strut:
      return "strut";
    case ComparedPart::ends:
      return "ends";
  }
  return "";
}

namespace {

/// The place at the same angle and height, at `radius` from the vessel's axis.
Vec3 onCylinder(const Vec3& place, double radius) {
  const double distance = std::max(place.head<2>().norm(), 1e-12);
  return {place.x() * radius / distance, place.y() * radius / distance, place.z()};
}

bool within(const PointTree& tree, const Vec3& place, double distance) {
  const auto nearest = tree.nearest(place, 1);
  return !nearest.empty() && nearest.front().distance < distance;
}

}  // namespace

ComparedFaces comparedFaces(const TriSurface& lumen, std::span<const Vec3> struts,
                            const ComparedPartsSettings& settings) {
  std::vector<Vec3> seen;
  for (std::size_t t = 0; t < lumen.triangles.size(); ++t)
    if (lumen.region[t] == SurfaceRegion::strut) seen.push_back(lumen.centre(t));
  const PointTree strutFaces(std::move(seen));
  double radius = 0.0;
  std::vector<Vec3> middles;
  for (const Vec3& place : struts) {
    if (within(strutFaces, place, settings.buriedFrom)) continue;
    radius = std::max(radius, place.head<2>().norm());
    middles.push_back(place);
  }
  for (Vec3& place : middles) place = onCylinder(place, radius);
  const PointTree buried(std::move(middles));
  const std::array ends{endPlane(lumen, SurfaceRegion::inlet), endPlane(lumen, SurfaceRegion::outlet)};
  const bool straight = liesAlongZ(lumen);
  const auto atEnd = [&](const Vec3& place) {
    return std::ranges::any_of(ends, [&](const EndPlane& end) {
      const Vec3 from = place - end.centre;
      // A bent lumen may pass the plane of an end elsewhere
      return std::abs(end.normal.dot(from)) < settings.endLength &&
             (straight || from.norm() < 2.0 * std::sqrt(end.area / std::numbers::pi));
    });
  };
  const auto partOf = [&](std::size_t t) {
    const Vec3 centre = lumen.centre(t);
    if (atEnd(centre)) return ComparedPart::ends;
    if (lumen.region[t] == SurfaceRegion::strut) return ComparedPart::strut;
    const bool nearStrut = within(strutFaces, centre, settings.strutReach) ||
                           within(buried, onCylinder(centre, radius), settings.strutReach);
    return nearStrut ? ComparedPart::betweenStruts : ComparedPart::smoothWall;
  };
  ComparedFaces faces;
  for (std::size_t t = 0; t < lumen.triangles.size(); ++t) {
    if (lumen.region[t] != SurfaceRegion::wall && lumen.region[t] != SurfaceRegion::strut) continue;
    faces.triangle.push_back(static_cast<std::uint32_t>(t));
    faces.part.push_back(partOf(t));
    faces.area.push_back(lumen.areaVector(t).norm());
  }
  return faces;
}

}  // namespace restenosis

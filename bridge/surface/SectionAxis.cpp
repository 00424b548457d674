#include "bridge/surface/SectionAxis.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "bridge/surface/LumenRefusal.h"

namespace restenosis {
namespace {

/// Over the radius there (assumed): the distance of sections, that from which on the outlet is the next one,
/// and how far a section may reach from its centre, so that another turn of the vessel is none of it.
constexpr double stepOverRadius = 0.5, lastStep = 0.8, reachOverRadius = 2.5;
constexpr int mostSections = 20000;

struct Section {
  Vec3 centre;
  double radius;  ///< of the circle of its area
};

/// An end as a section; `way`: out of the lumen.
struct End : Section {
  Vec3 way;
};

End endOf(const TriSurface& lumen, SurfaceRegion region) {
  End end{{Vec3::Zero(), 0}, Vec3::Zero()};
  double area = 0;
  for (std::size_t t = 0; t < lumen.triangles.size(); ++t) {
    if (lumen.region[t] != region) continue;
    const Vec3 vector = lumen.areaVector(t);
    end.way += vector;
    end.centre += vector.norm() * lumen.centre(t);
    area += vector.norm();
  }
  end.centre /= area;
  end.way.normalize();
  end.radius = std::sqrt(area / std::numbers::pi);
  return end;
}

/// Where a plane cuts the lumen near a point in it.
std::optional<Section> sectionAt(const TriSurface& lumen, const Vec3& point, const Vec3& normal,
                                 double reach) {
  double area = 0;
  Vec3 moment = Vec3::Zero();
  for (std::size_t t = 0; t < lumen.triangles.size(); ++t) {
    const auto& corners = lumen.triangles[t];
    Vec3 cut[2];
    int count = 0;
    for (int k = 0; k < 3 && count < 2; ++k) {
      const Vec3 a = lumen.vertices[corners[k]] - point, b = lumen.vertices[corners[(k + 1) % 3]] - point;
      const double over = a.dot(normal), next = b.dot(normal);
      if ((over >= 0) != (next >= 0)) cut[count++] = a + over / (over - next) * (b - a);
    }
    if (count < 2 || cut[0].norm() > reach) continue;
    const double turn = 0.5 * cut[0].cross(cut[1]).dot(normal);
    const bool counterclockwise = (cut[1] - cut[0]).dot(normal.cross(lumen.areaVector(t))) >= 0;
    const double part = counterclockwise ? turn : -turn;
    area += part;
    moment += part / 3 * (cut[0] + cut[1]);
  }
  if (!(area > 0)) return std::nullopt;
  return Section{point + moment / area, std::sqrt(area / std::numbers::pi)};
}

/// The direction at the end of an arc that begins in a direction and leads along a chord.
Vec3 afterArc(const Vec3& direction, const Vec3& chord) {
  const Vec3 unit = chord.normalized();
  return (2 * direction.dot(unit) * unit - direction).normalized();
}

}  // namespace

Centreline axisBySections(const TriSurface& lumen) {
  const End inlet = endOf(lumen, SurfaceRegion::inlet), outlet = endOf(lumen, SurfaceRegion::outlet);
  std::vector<Vec3> points{inlet.centre};
  Section last = inlet;
  Vec3 direction = -inlet.way;
  while ((outlet.centre - last.centre).norm() > lastStep * outlet.radius) {
    const double reach = reachOverRadius * last.radius;
    const auto first =
        sectionAt(lumen, last.centre + stepOverRadius * last.radius * direction, direction, reach);
    // Once more, square to the arc that leads there
    const auto section =
        first ? sectionAt(lumen, first->centre, afterArc(direction, first->centre - last.centre), reach)
              : first;
    if (!section || points.size() > mostSections)
      refuseLumen(fmt::format(
          "its axis cannot be followed from the inlet beyond {}: give it by 'centreline', or cut the "
          "lumen there",
          shownPlace(last.centre)));
    direction = afterArc(direction, section->centre - last.centre);
    last = *section;
    points.push_back(last.centre);
  }
  points.push_back(outlet.centre);
  return Centreline::through(points);
}

TriSurface straightened(const TriSurface& lumen, const Centreline& axis) {
  TriSurface straight = lumen;
  for (Vec3& vertex : straight.vertices) {
    vertex = axis.toStraight(vertex);
    vertex.z() = std::clamp(vertex.z(), 0.0, axis.length());
  }
  for (std::size_t t = 0; t < straight.triangles.size(); ++t)
    if (isEnd(straight.region[t]))
      for (const auto v : straight.triangles[t])
        straight.vertices[v].z() = straight.region[t] == SurfaceRegion::inlet ? 0.0 : axis.length();
  return straight;
}

}  // namespace restenosis

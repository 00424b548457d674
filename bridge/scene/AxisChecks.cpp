#include "bridge/scene/AxisChecks.h"

#include <fmt/format.h>

#include <numbers>

#include "bridge/surface/VesselAxis.h"
#include "tissue/parameters/Limit.h"

namespace restenosis {
namespace {

/// Of a bent vessel, its outer radius over the radius of curvature at most, by which distances along it
/// differ from those on its axis, and its angle [rad] (assumed: its ends must not meet).
constexpr double sharpestBend = 0.25, longestArc = 1.5 * std::numbers::pi;

Finding stenosisInTissue(const Scene& s, const Units&) {
  if (s.vessel.stenosis == 0 || !s.hasTissue()) return {};
  return "'stenosis' shapes a vessel without tissue; take it or [mechanics] out";
}

Finding stenosisOfLumenSurface(const Scene& s, const Units&) {
  if (s.vessel.stenosis == 0 || s.vessel.lumenSurface.empty()) return {};
  return "'stenosis' shapes a cylinder, but the lumen is that of 'lumenSurface'; take one of them out";
}

std::string_view bendKey(const Scene& s) {
  return s.vessel.centreline.empty() ? "curvatureRadius" : "centreline";
}

Finding bentTwice(const Scene& s, const Units&) {
  if (s.vessel.centreline.empty() || s.vessel.curvatureRadius == 0) return {};
  return "'centreline' in [vessel] says how it bends, and so does 'curvatureRadius'; take one of them out";
}

Finding stenosisOfCentreline(const Scene& s, const Units&) {
  if (s.vessel.stenosis == 0 || !hasRadiiAlong(s.vessel)) return {};
  return "'stenosis' shapes a cylinder, but 'centreline' in [vessel] has radii; take one of them out";
}

Finding bendOfLumenSurface(const Scene& s, const Units&) {
  if (s.vessel.lumenSurface.empty() || (s.vessel.curvatureRadius == 0 && s.vessel.centreline.empty()))
    return {};
  return fmt::format(
      "'{}' bends a vessel with a straight lumen, but the lumen is that of 'lumenSurface'; take one "
      "of them out",
      bendKey(s));
}

/// How far a vessel reaches from its axis.
double outerRadius(const Scene& s) {
  return s.vessel.lumenDiameter / 2 + (s.hasTissue() ? s.vessel.wallThickness : 0) +
         (s.stent ? s.stent->deploymentDepth : 0);
}

Finding arcTooSharp(const Scene& s, const Units& u) {
  if (s.vessel.curvatureRadius == 0) return {};
  if (s.vessel.curvatureRadius < outerRadius(s) / sharpestBend)
    return fmt::format(
        "'curvatureRadius' in [vessel] is {}; a vessel that reaches {} from its axis needs at least {}",
        shownIn(u, s.vessel.curvatureRadius, "mm"), shownIn(u, outerRadius(s), "mm"),
        shownIn(u, outerRadius(s) / sharpestBend, "mm"));
  if (s.vessel.length > longestArc * s.vessel.curvatureRadius)
    return fmt::format(
        "'curvatureRadius' in [vessel] is {}, on which a vessel of {} goes around too far; at most {}",
        shownIn(u, s.vessel.curvatureRadius, "mm"), shownIn(u, s.vessel.length, "mm"),
        shownIn(u, longestArc * s.vessel.curvatureRadius, "mm"));
  return {};
}

/// Of an axis that a file has.
Finding axisTooSharp(const Scene& s, const Units& u, std::string_view key, std::string_view advice) {
  const double sharpest = sharpestRadius(s.vessel);
  if (sharpest >= outerRadius(s) / sharpestBend) return {};
  return fmt::format(
      "'{}' in [vessel] has an axis with a radius of curvature of {:.3g} mm; a vessel that reaches {} from "
      "its axis "
      "needs at least {}: {}",
      key, u.fromSi(sharpest, "mm"), shownIn(u, outerRadius(s), "mm"),
      shownIn(u, outerRadius(s) / sharpestBend, "mm"), advice);
}

Finding centrelineTooSharp(const Scene& s, const Units& u) {
  if (s.vessel.centreline.empty() || s.vessel.curvatureRadius > 0) return {};
  return axisTooSharp(s, u, "centreline", "leave out points where it is rough");
}

Finding surfaceTooSharp(const Scene& s, const Units& u) {
  if (!s.vessel.lumenSurfaceIsBent) return {};
  return axisTooSharp(s, u, "lumenSurface", "tissue is not built around sharper bends");
}

Finding stenosisTooLong(const Scene& s, const Units& u) {
  if (s.vessel.stenosis == 0 || !exceeds(s.vessel.stenosisLength, s.vessel.length)) return {};
  return fmt::format("'stenosisLength' in [vessel] is {}, longer than the vessel ({})",
                     shownIn(u, s.vessel.stenosisLength, "mm"), shownIn(u, s.vessel.length, "mm"));
}

}  // namespace

const std::vector<SceneCheck>& axisChecks() {
  static const std::vector<SceneCheck> table = {
      {{"vessel.stenosis", "mechanics"}, stenosisInTissue},
      {{"vessel.stenosis", "vessel.lumenSurface"}, stenosisOfLumenSurface},
      {{"vessel.stenosis", "vessel.centreline"}, stenosisOfCentreline},
      {{"vessel.centreline", "vessel.curvatureRadius"}, bentTwice},
      {{"vessel.lumenSurface", "vessel.curvatureRadius", "vessel.centreline"}, bendOfLumenSurface},
      {{"vessel.curvatureRadius", "vessel.lumenDiameter", "vessel.wallThickness", "vessel.length",
        "stent.deploymentDepth", "mechanics"},
       arcTooSharp},
      {{"vessel.centreline", "vessel.lumenDiameter", "vessel.wallThickness", "stent.deploymentDepth",
        "mechanics"},
       centrelineTooSharp},
      {{"vessel.lumenSurface", "vessel.lumenDiameter", "vessel.wallThickness", "stent.deploymentDepth",
        "mechanics"},
       surfaceTooSharp},
      {{"vessel.stenosisLength", "vessel.stenosis", "vessel.length"}, stenosisTooLong},
  };
  return table;
}

}  // namespace restenosis

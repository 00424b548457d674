#include "tissue/stent/StrutAgents.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tissue/stent/StentDesign.h"
#include "tissue/stent/StrutFit.h"
#include "tissue/vessel/Cylindrical.h"

namespace restenosis {
namespace {

using SectionPoint = std::pair<double, double>;  // across, outward

/// Values from -half to half in equal steps of at most `spacing`; one in the middle where half is 0.
std::vector<double> evenlySpaced(double half, double spacing) {
  if (half <= 0) return {0.0};
  const int steps = static_cast<int>(std::ceil(2 * half / spacing - 1e-9));
  std::vector<double> values;
  for (int n = 0; n <= steps; ++n) values.push_back(half * (2.0 * n / steps - 1));
  return values;
}

/// Centres of the spheres of one cross-section: its boundary set in by `radius`, or all of it.
std::vector<SectionPoint> sectionPoints(const StrutSegment& segment, double radius, bool filled) {
  const double halfAcross = segment.width / 2 - radius, halfOutward = segment.thickness / 2 - radius;
  std::vector<SectionPoint> points;
  if (segment.round) {
    const double largest = std::max(halfAcross, halfOutward);
    const int rings = static_cast<int>(std::ceil(largest / radius - 1e-9));
    for (int ring = rings; ring >= (filled || rings == 0 ? 0 : rings); --ring) {
      const double share = rings > 0 ? static_cast<double>(ring) / rings : 0;
      const int count =
          std::max(1, static_cast<int>(std::ceil(2 * std::numbers::pi * share * largest / radius - 1e-9)));
      for (int n = 0; n < count; ++n) {
        const double angle = 2 * std::numbers::pi * n / count;
        points.emplace_back(share * halfAcross * std::sin(angle), share * halfOutward * std::cos(angle));
      }
    }
    return points;
  }
  const auto across = evenlySpaced(halfAcross, radius), outward = evenlySpaced(halfOutward, radius);
  for (std::size_t i = 0; i < across.size(); ++i) {
    for (std::size_t j = 0; j < outward.size(); ++j) {
      const bool boundary = i == 0 || i + 1 == across.size() || j == 0 || j + 1 == outward.size();
      if (boundary || filled) points.emplace_back(across[i], outward[j]);
    }
  }
  return points;
}

}  // namespace

std::vector<StrutSphere> coverWithSpheres(const std::vector<StrutSegment>& segments, double cellRadius) {
  std::vector<StrutSphere> spheres;
  for (std::size_t n = 0; n < segments.size(); ++n) {
    const StrutSegment& segment = segments[n];
    const double radius = std::min({cellRadius, segment.width / 2, segment.thickness / 2});
    const int count = std::max(1, static_cast<int>(std::ceil(segment.length() / radius - 1e-9)));
    for (int k = 0; k < count; ++k) {
      const bool atA = k == 0 && segment.openA, atB = k + 1 == count && segment.openB;
      // Flush with an open end, as far as the segment is long enough.
      const double flush = segment.length() > 0 ? std::min(radius / segment.length(), 0.5) : 0.5;
      const double along = atA ? flush : atB ? 1 - flush : (k + 0.5) / count;
      for (const auto& [across, outward] : sectionPoints(segment, radius, atA || atB)) {
        spheres.push_back(
            {.segment = n, .along = along, .across = across, .outward = outward, .radius = radius});
      }
    }
  }
  return spheres;
}

Stent stentOfDesign(const StentParameters& parameters, const VesselParameters& vessel) {
  Stent stent;
  stent.segments =
      stentDesign(parameters.design)
          .build(parameters, {.vesselLength = vessel.length, .outerRadius = vessel.lumenDiameter / 2});
  stent.spheres = coverWithSpheres(stent.segments, vessel.cellRadius);
  return stent;
}

Stent stentOfSpheres(const AgentTable& struts, const VesselParameters& vessel) {
  const double outwards = outwardsToLumen(struts, vessel);
  Stent stent;
  for (Index i = 0; i < struts.agents.size(); ++i) {
    const Vec3 place = struts.agents.position(i);
    const double radius = struts.agents.radius[i];
    stent.segments.push_back({.a = place,
                              .b = place,
                              .radial = radialAt(place),
                              .width = 2 * radius,
                              .thickness = 2 * radius,
                              .round = true});
    stent.spheres.push_back({.segment = i, .along = 0, .across = 0, .outward = 0, .radius = radius});
  }
  return stent.movedOutwards(outwards);
}

}  // namespace restenosis

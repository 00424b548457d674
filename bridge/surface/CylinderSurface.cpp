#include "bridge/surface/CylinderSurface.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace restenosis {
namespace {

constexpr double fullTurn = 2 * std::numbers::pi;
/// See `cylinderSpacing`.
constexpr double usualSpacing = 20e-6, usualDiameter = 1.8e-3, mostLayers = 10000;

/// Vertices around the axis at one height.
struct Ring {
  std::uint32_t first, count;
  std::uint32_t at(std::uint32_t n) const { return first + n % count; }
};

Ring addRing(TriSurface& s, double radius, double z, std::uint32_t count) {
  const Ring ring{static_cast<std::uint32_t>(s.vertices.size()), count};
  for (std::uint32_t n = 0; n < count; ++n) {
    const double angle = fullTurn * n / count;
    s.vertices.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
  }
  return ring;
}

/// Triangles between an inner and an outer ring of a cap, going round both at once by angle.
void stitch(TriSurface& s, Ring inner, Ring outer, bool facesUp, SurfaceRegion region) {
  auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (facesUp) {
      s.triangles.push_back({a, b, c});
    } else {
      s.triangles.push_back({a, c, b});
    }
    s.region.push_back(region);
  };
  // A ring of one vertex is the centre, which has no edge to go along.
  const std::uint32_t innerSteps = inner.count == 1 ? 0 : inner.count;
  std::uint32_t i = 0, o = 0;
  while (i < innerSteps || o < outer.count) {
    const bool outerNext =
        i == innerSteps || (o < outer.count && (o + 0.5) * inner.count <= (i + 0.5) * outer.count);
    if (outerNext) {
      add(inner.at(i), outer.at(o), outer.at(o + 1));
      ++o;
    } else {
      add(inner.at(i), outer.at(o), inner.at(i + 1));
      ++i;
    }
  }
}

void addCap(TriSurface& s, Ring rim, double radius, double z, double spacing, bool facesUp,
            SurfaceRegion region) {
  const int rings = std::max(1, static_cast<int>(std::lround(radius / spacing)));
  Ring outer = rim;
  for (int n = rings - 1; n > 0; --n) {
    const Ring inner =
        addRing(s, radius * n / rings, z, std::min(rim.count, static_cast<std::uint32_t>(6 * n)));
    stitch(s, inner, outer, facesUp, region);
    outer = inner;
  }
  stitch(s, addRing(s, 0.0, z, 1), outer, facesUp, region);
}

}  // namespace

double cylinderRadius(const VesselParameters& vessel, double z) {
  const double radius = 0.5 * vessel.lumenDiameter, offset = z - 0.5 * vessel.length;
  if (std::abs(offset) >= 0.5 * vessel.stenosisLength) return radius;
  return radius * (1 - 0.5 * vessel.stenosis * (1 + std::cos(fullTurn * offset / vessel.stenosisLength)));
}

CylinderSpacing cylinderSpacing(const VesselParameters& vessel) {
  const double around = usualSpacing * (vessel.lumenDiameter / usualDiameter);
  return {around, std::clamp(vessel.length / mostLayers, around, std::max(around, usualSpacing))};
}

TriSurface cylinderSurface(const VesselParameters& vessel) {
  return cylinderSurface(vessel, cylinderSpacing(vessel));
}

TriSurface cylinderSurface(const VesselParameters& vessel, const CylinderSpacing& spacing) {
  if (!(spacing.around > 0 && spacing.along > 0))
    throw std::invalid_argument("a cylinder surface needs a positive spacing");
  if (!(vessel.stenosis >= 0 && vessel.stenosis < 1))
    throw std::invalid_argument("a stenosis must leave some lumen: its depth must lie in [0, 1)");
  const double radius = 0.5 * vessel.lumenDiameter;
  const auto corners =
      static_cast<std::uint32_t>(std::max(12L, std::lround(fullTurn * radius / spacing.around)));
  const int layers = std::max(2, static_cast<int>(std::lround(vessel.length / spacing.along)));
  const double widening = std::sqrt((fullTurn / corners) / std::sin(fullTurn / corners));

  TriSurface s;
  std::vector<Ring> rings;
  for (int k = 0; k <= layers; ++k) {
    const double z = k == layers ? vessel.length : vessel.length * k / layers;
    rings.push_back(addRing(s, widening * cylinderRadius(vessel, z), z, corners));
  }
  for (int k = 0; k < layers; ++k)
    for (std::uint32_t n = 0; n < corners; ++n) {
      const auto a = rings[k].at(n), b = rings[k].at(n + 1), c = rings[k + 1].at(n),
                 d = rings[k + 1].at(n + 1);
      s.triangles.push_back({a, b, d});
      s.triangles.push_back({a, d, c});
      s.region.insert(s.region.end(), 2, SurfaceRegion::wall);
    }
  addCap(s, rings.front(), widening * cylinderRadius(vessel, 0), 0.0, spacing.around, false,
         SurfaceRegion::inlet);
  addCap(s, rings.back(), widening * cylinderRadius(vessel, vessel.length), vessel.length, spacing.around,
         true, SurfaceRegion::outlet);
  return s;
}

}  // namespace restenosis

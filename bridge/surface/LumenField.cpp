#include "bridge/surface/LumenField.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "tissue/vessel/RadiusMap.h"

namespace restenosis {
namespace {

/// Values farther from a surface than this many spacings are not needed: trilinear interpolation, the joint
/// of strut and tissue, and the blur reach less far.
constexpr double bandSpacings = 3.0;

struct Obstacles {
  std::vector<Ball> tissue, strut;
  double outerRadius = 0;  ///< distance from the axis of the outermost tissue agent's centre [m]
  double eelRadii = 0;     ///< sum over the EEL's agents [m]
  std::size_t eel = 0;     ///< their number
  double meanEelRadius() const { return eel > 0 ? eelRadii / static_cast<double>(eel) : 0; }
};

Obstacles sortAgents(const AgentStore& agents) {
  Obstacles found;
  for (Index i = 0; i < agents.size(); ++i) {
    const Ball s{agents.position(i), agents.radius[i]};
    if (agents.kind[i] == AgentKind::strut) {
      found.strut.push_back(s);
    } else {
      found.tissue.push_back(s);
      found.outerRadius = std::max(found.outerRadius, std::hypot(s.centre.x(), s.centre.y()));
      if (agents.kind[i] == AgentKind::eel) found.eelRadii += s.radius, ++found.eel;
    }
  }
  return found;
}

/// Takes what lies outside of the wall for solid: beyond its outermost agent, and beyond the EEL where there
/// is one, or the space outside of a bulging wall would be a lumen beside the lumen.
void wallOff(GridField& field, double outerRadius, const RadiusMap& eel, double clip) {
  const LumenGrid& g = field.grid;
  const double lowest = eel.lowest();
  const double beyond = eel.empty() ? std::numeric_limits<double>::infinity()
                                    : std::ranges::max(eel.values()) + clip + g.spacing;
#pragma omp parallel for schedule(static)
  for (int k = 0; k < g.nz; ++k)
    for (int j = 0; j < g.ny; ++j)
      for (int i = 0; i < g.nx; ++i) {
        float& v = field.values[g.index(i, j, k)];
        const double r = std::sqrt(g.x(i) * g.x(i) + g.y(j) * g.y(j));  // hypot would take most of the time
        double limit = outerRadius;
        // Inside of the wall its own agents say what is solid
        if (v > 0 && r > beyond)
          limit = 0;
        else if (v > 0 && lowest - r < v && eel.lowestNear(g.x(i), g.y(j), g.z(k)) - r < v)
          limit = std::min(limit, eel.at({g.x(i), g.y(j), g.z(k)}));
        const double inside = std::max(limit - r, -clip);
        v = std::min(v, static_cast<float>(inside));
      }
}

}  // namespace

LumenField LumenField::fromDistances(GridField tissue, const BandField* strut, double jointWidth) {
  std::optional<Parts> parts;
  GridField& lumen = tissue;
  if (strut) {
    parts = Parts{.tissue = BandField(tissue, *strut), .strut = *strut};
    uniteRounded(lumen, parts->strut, jointWidth);
  }
  const LumenTopology topology = keepLumen(lumen, parts ? &parts->strut : nullptr);
  return {lumen, std::move(parts), topology};
}

LumenField LumenField::fromTissue(const AgentStore& agents, std::span<const StrutSegment> struts,
                                  double length, const LumenFieldSettings& settings) {
  StrutBand band(struts);
  return fromTissue(agents, band, length, settings);
}

LumenField LumenField::fromTissue(const AgentStore& agents, StrutBand& struts, double length,
                                  const LumenFieldSettings& settings) {
  if (!(settings.smoothing >= 0 && settings.blurFraction >= 0 && settings.jointWidth >= 0))
    throw std::invalid_argument("smoothing, blur and joint of a lumen field must not be negative");
  Obstacles obstacles = sortAgents(agents);
  if (obstacles.tissue.empty()) throw std::invalid_argument("a lumen field needs tissue around the lumen");
  const double h = settings.resolution, clip = bandSpacings * h;
  const LumenGrid grid(length, obstacles.outerRadius + 2 * h, h);

  const double reach = settings.smoothing > 0 ? std::max(settings.smoothing + h, clip) : clip;
  GridField tissue = sphereDistance(grid, std::move(obstacles.tissue), reach);
  const RadiusMap eel(agents, AgentKind::eel, 2 * obstacles.meanEelRadius());
  wallOff(tissue, obstacles.outerRadius, eel, clip);
  if (settings.smoothing > 0) {
    closeByBall(tissue, settings.smoothing, clip);
    blur(tissue, settings.blurFraction * settings.smoothing);
  }
  std::optional<BandField> spheres;
  const BandField* strut = struts.on(grid, clip);
  if (!strut && !obstacles.strut.empty())
    strut = &spheres.emplace(sphereBand(grid, std::move(obstacles.strut), clip));
  return fromDistances(std::move(tissue), strut, settings.jointWidth * h);
}

LumenField LumenField::fromFunction(const std::function<double(const Vec3&)>& distance, double length,
                                    double halfWidth, double resolution) {
  const LumenGrid grid(length, halfWidth, resolution);
  GridField field(grid, 0.0F);
  for (int k = 0; k < grid.nz; ++k)
    for (int j = 0; j < grid.ny; ++j)
      for (int i = 0; i < grid.nx; ++i)
        field.values[grid.index(i, j, k)] = static_cast<float>(distance(grid.node(i, j, k)));
  return fromDistances(std::move(field), nullptr, 0.0);
}

bool LumenField::isStrut(const Vec3& point) const {
  return parts_ && !parts_->strut.evenAround(point) &&
         std::abs(parts_->strut.at(point)) < std::abs(parts_->tissue.at(point));
}

}  // namespace restenosis

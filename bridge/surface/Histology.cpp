#include "bridge/surface/Histology.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tissue/vessel/Cylindrical.h"

namespace restenosis {
namespace {

// Standard deviation over which a lamina is averaged, in cell radii, as for OuterConfinement.
constexpr double smoothing = 2;

Vec3 onRay(const RadialMap& lumen, int plane, int angle) {
  return {std::cos(lumen.angle(angle)), std::sin(lumen.angle(angle)), lumen.z(plane)};
}

}  // namespace

Histology::Histology(const AgentStore& agents, double cellRadius)
    : agents_(agents),
      iel_(agents, AgentKind::iel, smoothing * cellRadius),
      eel_(agents, AgentKind::eel, smoothing * cellRadius) {}

template <class Inner, class Outer>
double Histology::areaBetween(const RadialMap& lumen, const Inner& inner, const Outer& outer) {
  double area = 0;
  for (int a = 0; a < lumen.angles(); ++a) {
    const double low = inner(a), high = outer(a);
    area += 0.5 * (high * high - low * low) * 2 * std::numbers::pi / lumen.angles();
  }
  return area;
}

std::vector<double> Histology::insideIel(const RadialMap& lumen) const {
  std::vector<double> areas(static_cast<std::size_t>(lumen.planes()));
  for (int k = 0; k < lumen.planes(); ++k) {
    areas[k] = areaBetween(
        lumen, [&](int a) { return lumen.radius(k, a); }, [&](int a) { return iel_.at(onRay(lumen, k, a)); });
  }
  return areas;
}

bool Histology::inIntima(const Vec3& place) const { return radiusOf(place) < iel_.at(place); }

std::vector<HistologySection> Histology::sections(const RadialMap& lumen,
                                                  const std::vector<double>& afterDeployment) const {
  std::vector<HistologySection> sections(static_cast<std::size_t>(lumen.planes()));
  const std::vector<double> inside = insideIel(lumen);
  for (int k = 0; k < lumen.planes(); ++k) {
    HistologySection& section = sections[k];
    section.intimaArea = inside[k] - afterDeployment[k];
    section.mediaArea = areaBetween(
        lumen, [&](int a) { return iel_.at(onRay(lumen, k, a)); },
        [&](int a) { return eel_.at(onRay(lumen, k, a)); });
    const double open = section.intimaArea + lumen.lumenArea(k);
    section.relativeIntimaArea = open > 0 ? section.intimaArea / open : 0;
  }
  for (Index i = 0; i < agents_.size(); ++i) {
    if (agents_.kind[i] != AgentKind::smc || !inIntima(agents_.position(i))) continue;
    HistologySection& section = sections[static_cast<std::size_t>(lumen.nearestPlane(agents_.z[i]))];
    section.intimaCells += 1;
    section.intimaCellsInCycle += agents_.state[i] != CycleState::g0;
    section.intimaVolume += std::pow(agents_.radius[i], 3);
    section.intimaMatrix += agents_.matrix[i];
  }
  return sections;
}

HistologySection Histology::mean(const RadialMap& lumen, const std::vector<HistologySection>& sections,
                                 double from, double to) {
  HistologySection mean;
  double weights = 0;
  const double nearest = lumen.z(lumen.nearestPlane(0.5 * (from + to)));
  from = std::min(from, nearest), to = std::max(to, nearest);
  for (int k = 0; k < lumen.planes(); ++k) {
    if (lumen.z(k) < from || lumen.z(k) > to) continue;
    const double weight = lumen.planeWeight(k);
    const HistologySection& section = sections[k];
    weights += weight;
    mean.intimaArea += weight * section.intimaArea;
    mean.mediaArea += weight * section.mediaArea;
    mean.relativeIntimaArea += weight * section.relativeIntimaArea;
    mean.intimaCells += section.intimaCells, mean.intimaCellsInCycle += section.intimaCellsInCycle;
    mean.intimaVolume += section.intimaVolume, mean.intimaMatrix += section.intimaMatrix;
  }
  mean.intimaArea /= weights, mean.mediaArea /= weights, mean.relativeIntimaArea /= weights;
  return mean;
}

}  // namespace restenosis

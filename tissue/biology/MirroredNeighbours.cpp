#include "MirroredNeighbours.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace restenosis {

namespace {

double largest(std::span<const double> radius) {
  return radius.empty() ? 0.0 : *std::ranges::max_element(radius);
}

/// Half the distance to which most agents look: fewer candidates outside the sphere than with whole ones.
double cellSize(const AgentShapes& agents, double range) {
  const double sum = std::accumulate(agents.radius.begin(), agents.radius.end(), 0.0);
  return sum > 0 ? range * sum / agents.size() : 1.0;
}

}  // namespace

MirroredNeighbours::MirroredNeighbours(const AgentShapes& agents, double range, double vesselLength)
    : agents_(agents),
      range_(range),
      vesselLength_(vesselLength),
      largestRadius_(largest(agents.radius)),
      grid_(
          agents.size(), [&](std::size_t i) { return agents.position(static_cast<Index>(i)); },
          cellSize(agents, range)) {}

double MirroredNeighbours::facing(Index j, const Vec3& offset, double distance) const {
  const double x = agents_.x[j], y = agents_.y[j], rho = std::hypot(x, y);
  if (rho <= 0 || distance <= 0) return 1.0;
  return std::min(1.0, std::abs(offset.x() * x + offset.y() * y) / (rho * distance));
}

void MirroredNeighbours::gather(Index i, double range, std::vector<ContactNeighbour>& found) const {
  found.clear();
  const double radius = agents_.radius[i];
  forEachWithin(range, agents_.position(i), radius, [&](Index j, const Vec3& offset, double distance) {
    if (j == i && distance < 2 * radius) return;
    const bool lamina = agents_.kind[j] == AgentKind::iel || agents_.kind[j] == AgentKind::eel;
    found.push_back(
        {offset, distance, agents_.radius[j], agents_.kind[j], lamina ? facing(j, offset, distance) : 1.0});
  });
}

}  // namespace restenosis

#include "tissue/neighbours/MirroredNeighbours.h"

#include <algorithm>
#include <cmath>

#include "tissue/agents/Chunks.h"

namespace restenosis {

namespace {

/// Cosine between `offset`, which leads to a place (x, y) from the axis or to its image, and the radius of
/// the vessel there: the laminae's normal.
double facing(double x, double y, const Vec3& offset, double distance) {
  const double rho = std::hypot(x, y);
  if (rho <= 0 || distance <= 0) return 1.0;
  return std::min(1.0, std::abs(offset.x() * x + offset.y() * y) / (rho * distance));
}

// Where agents are looked for in cells of this times their mean radius and the range. Speed only.
constexpr double cellOverReach = 2;

}  // namespace

template <class AgentAt>
MirroredNeighbours::MirroredNeighbours(const AgentShapes& agents, std::size_t count, const AgentAt& agentAt,
                                       double range, double vesselLength)
    : agents_(agents),
      vesselLength_(vesselLength),
      radii_(reduceInChunks<Radii>(count,
                                   [&](std::size_t k, Radii& part) {
                                     const double radius = agents.radius[agentAt(k)];
                                     part.join({radius, radius});
                                   })),
      grid_(
          count, [&](std::size_t k) { return agents.position(agentAt(k)); },
          count > 0 ? cellOverReach * range * radii_.sum / static_cast<double>(count) : 1.0) {
  for (auto* values : {&x_, &y_, &z_, &radius_}) {
    values->resize(count + lanes - 1);  // those that search for the last ones read on
    std::fill(values->begin() + count, values->end(), 0.0);
  }
  agent_.resize(count);
  forEachInChunks(count, [&](std::size_t n) {
    const Index i = agentAt(grid_.order()[n]);
    x_.data()[n] = agents.x[i], y_.data()[n] = agents.y[i], z_.data()[n] = agents.z[i];
    radius_.data()[n] = agents.radius[i];
    agent_.data()[n] = i;
  });
}

MirroredNeighbours::MirroredNeighbours(const AgentShapes& agents, double range, double vesselLength)
    : MirroredNeighbours(
          agents, agents.size(), [](std::size_t k) { return static_cast<Index>(k); }, range, vesselLength) {}

MirroredNeighbours::MirroredNeighbours(const AgentShapes& agents, std::span<const Index> some, double range,
                                       double vesselLength)
    : MirroredNeighbours(
          agents, some.size(), [&](std::size_t k) { return some[k]; }, range, vesselLength) {}

void MirroredNeighbours::gather(Index i, double range, std::vector<ContactNeighbour>& found) const {
  found.clear();
  const double radius = agents_.radius[i];
  const auto keep = [&](const Found& other) {
    if (other.agent == i && other.distance < 2 * radius) return;
    const AgentKind kind = agents_.kind[other.agent];
    const bool lamina = kind == AgentKind::iel || kind == AgentKind::eel;
    const double cosine =
        lamina ? facing(agents_.x[other.agent], agents_.y[other.agent], other.offset, other.distance) : 1.0;
    found.push_back({other.offset, other.distance, other.radius, kind, cosine});
  };
  forEachWithin(range, agents_.position(i), radius, keep);
}

}  // namespace restenosis

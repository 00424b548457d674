#include "tissue/vessel/PoissonScatter.h"

#include <cmath>
#include <numbers>

#include "tissue/vessel/Cylindrical.h"

namespace restenosis {

PoissonScatter::PoissonScatter(std::uint64_t seed, double length, double outerRadius, std::size_t count,
                               double largest)
    : seed_(seed),
      length_(length),
      largest_(largest),
      grid_({-outerRadius, -outerRadius, 0}, {outerRadius, outerRadius, length}, count, 2 * largest) {}

Vec3 PoissonScatter::draw(RandomStream& stream, const Region& region) const {
  const auto& [inner, outer] = region;
  const double least = inner.least() * inner.least(), greatest = outer.greatest() * outer.greatest();
  // Steeper than this no wall is that can be packed; where one is, it gets too few agents by so much.
  constexpr double steepest = 2;
  for (;;) {
    const double fromAxis = std::sqrt(least + (greatest - least) * stream.uniform());
    const double angle = 2 * std::numbers::pi * stream.uniform();
    const Vec3 place = toCartesian({fromAxis, angle, length_ * stream.uniform()});
    if (inner.isCylinder() && outer.isCylinder()) return place;
    if (&inner != &outer) {
      if (fromAxis >= inner.at(place) && fromAxis <= outer.at(place)) return place;
    } else if (steepest * outer.greatest() * stream.uniform() <= outer.areaElementAt(place)) {
      return atRadius(place, outer.at(place));
    }
  }
}

bool PoissonScatter::isFree(const AgentStore& agents, const Vec3& place, double radius) const {
  return !grid_.anyCandidate(place, share_ * (radius + largest_), [&](Index other) {
    const double reach = share_ * (radius + agents.radius[other]);
    return (agents.position(other) - place).squaredNorm() < reach * reach;
  });
}

void PoissonScatter::add(AgentStore& agents, AgentKind kind, Index count, const RadiusOf& radiusOf,
                         const SurfaceFromAxis& inner, const SurfaceFromAxis& outer) {
  const Region region{inner, outer};
  share_ = initialShare;
  for (const Index end = agents.size() + count; agents.size() < end;) {
    if (callback_ && (end - agents.size()) % agentsBetweenCallbacks == 0) callback_();
    RandomStream stream(seed_, agents.nextId, 0, RandomPurpose::packing);
    const double radius = radiusOf(agents.nextId);
    Vec3 place = draw(stream, region);
    for (int tries = 1; !isFree(agents, place, radius); ++tries) {
      if (tries % triesBeforeLowering == 0) share_ *= 0.99;
      place = draw(stream, region);
    }
    agents.append(kind, place, radius);
    grid_.add(place);
  }
}

}  // namespace restenosis

#include "PoissonScatter.h"

#include "Cylindrical.h"

namespace restenosis {

PoissonScatter::PoissonScatter(std::uint64_t seed, double length, double outerRadius, double largest)
    : seed_(seed),
      length_(length),
      largest_(largest),
      grid_({-outerRadius, -outerRadius, 0}, {outerRadius, outerRadius, length}, 2 * largest) {}

void PoissonScatter::add(AgentStore& agents, AgentKind kind, double radius, double innerLimit,
                         double outerLimit) {
  RandomStream stream(seed_, agents.nextId, 0, RandomPurpose::packing);
  for (int tries = 1;; ++tries) {
    const double inner = innerLimit * innerLimit, outer = outerLimit * outerLimit;
    const double fromAxis = std::sqrt(inner + (outer - inner) * stream.uniform());
    const double angle = 2 * std::numbers::pi * stream.uniform();
    const Vec3 place = toCartesian({fromAxis, angle, length_ * stream.uniform()});
    const bool isFree = grid_.visit(place, share_ * (radius + largest_), [&](Index other, double squared) {
      const double reach = share_ * (radius + agents.radius[other]);
      return squared >= reach * reach;
    });
    if (isFree) {
      grid_.insert(agents.append(kind, place, radius), place);
      return;
    }
    if (tries % triesBeforeLowering == 0) share_ *= 0.99;
  }
}

}  // namespace restenosis

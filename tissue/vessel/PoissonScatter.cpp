#include "PoissonScatter.h"

#include "Cylindrical.h"

namespace restenosis {

PoissonScatter::PoissonScatter(std::uint64_t seed, double length, double outerRadius, double largest)
    : seed_(seed),
      length_(length),
      largest_(largest),
      grid_({-outerRadius, -outerRadius, 0}, {outerRadius, outerRadius, length}, 2 * largest) {}

Vec3 PoissonScatter::draw(RandomStream& stream, const SurfaceFromAxis& inner,
                          const SurfaceFromAxis& outer) const {
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

void PoissonScatter::add(AgentStore& agents, AgentKind kind, double radius, const SurfaceFromAxis& inner,
                         const SurfaceFromAxis& outer) {
  RandomStream stream(seed_, agents.nextId, 0, RandomPurpose::packing);
  for (int tries = 1;; ++tries) {
    const Vec3 place = draw(stream, inner, outer);
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

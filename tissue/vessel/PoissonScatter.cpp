#include "PoissonScatter.h"

#include <algorithm>
#include <array>

#include "Cylindrical.h"

namespace restenosis {

PoissonScatter::PoissonScatter(std::uint64_t seed, double length, double outerRadius, double smallest,
                               double largest)
    : seed_(seed),
      length_(length),
      smallest_(smallest),
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
  // Tries are all over the wall, so that each waits for memory: those of a batch wait together.
  std::array<Vec3, 8> batch;
  std::size_t next = 0, drawn = 0;
  for (int tries = 1;; ++tries) {
    if (next == drawn) {
      drawn = std::min(batch.size(), 2 * drawn + 1), next = 0;
      for (std::size_t n = 0; n < drawn; ++n) grid_.fetch(batch[n] = draw(stream, inner, outer));
    }
    const Vec3& place = batch[next++];
    // Most that are in the way are so near that their radii need not be read.
    const double least = share_ * (radius + smallest_);
    const bool isFree = grid_.visit(place, share_ * (radius + largest_), [&](Index other, double squared) {
      if (squared < least * least) return false;
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

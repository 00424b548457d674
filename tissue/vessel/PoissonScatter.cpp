#include "tissue/vessel/PoissonScatter.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "tissue/agents/Chunks.h"
#include "tissue/vessel/Cylindrical.h"

namespace restenosis {

PoissonScatter::PoissonScatter(std::uint64_t seed, double length, double outerRadius, double smallest,
                               double largest)
    : seed_(seed),
      length_(length),
      smallest_(smallest),
      largest_(largest),
      grid_({-outerRadius, -outerRadius, 0}, {outerRadius, outerRadius, length}, 2 * largest) {}

Vec3 PoissonScatter::draw(RandomStream& stream, const Region& region) const {
  const auto& [inner, outer] = region;
  const double least = inner.least() * inner.least(), greatest = outer.greatest() * outer.greatest();
  // Bound of the area element over the radius; no wall that can be packed is steeper. Steeper parts would get
  // too few agents.
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

void PoissonScatter::tryNext(Seeker& seeker, const Region& region) const {
  if (seeker.next == seeker.drawn) {
    seeker.drawn = std::min(seeker.ahead.size(), 2 * seeker.drawn + 1), seeker.next = 0;
    for (Vec3& place : std::span(seeker.ahead).first(seeker.drawn))
      grid_.fetch(place = draw(seeker.stream, region));
  }
  seeker.place = seeker.ahead[seeker.next++];
  ++seeker.tries;
}

bool PoissonScatter::seek(Seeker& seeker, const Region& region, const AgentStore& agents) const {
  // Most blocking agents are so near that their radii need not be read.
  const double least = share_ * (seeker.radius + smallest_);
  do {
    tryNext(seeker, region);
    const bool isFree =
        grid_.visit(seeker.place, share_ * (seeker.radius + largest_), [&](Index other, double squared) {
          if (squared < least * least) return false;
          const double reach = share_ * (seeker.radius + agents.radius[other]);
          return squared >= reach * reach;
        });
    if (isFree) return true;
  } while (seeker.tries % triesBeforeLowering != 0);
  return false;
}

bool PoissonScatter::isFreeOf(std::span<const Index> others, const Seeker& seeker,
                              const AgentStore& agents) const {
  return std::ranges::none_of(others, [&](Index other) {
    const double reach = share_ * (seeker.radius + agents.radius[other]);
    return (agents.position(other) - seeker.place).squaredNorm() < reach * reach;
  });
}

void PoissonScatter::add(AgentStore& agents, AgentKind kind, Index count, const RadiusOf& radiusOf,
                         const SurfaceFromAxis& inner, const SurfaceFromAxis& outer) {
  const Region region{inner, outer};
  share_ = initialShare;
  std::vector<std::optional<Seeker>> seekers;
  std::vector<std::uint8_t> found;
  std::vector<Index> placed;
  for (const Index end = agents.size() + count; agents.size() < end;) {
    if (meanwhile_) meanwhile_();
    const AgentId first = agents.nextId;
    const std::size_t batch = std::min(batchSize, end - agents.size());
    seekers.assign(batch, {});
    found.assign(batch, 0);
    placed.clear();
    const auto seekPlaces = [&](std::size_t from, std::size_t to) {
      for (std::size_t n = from; n < to; ++n) {
        const AgentId id = first + n;
        seekers[n].emplace(RandomStream(seed_, id, 0, RandomPurpose::packing), radiusOf(id));
        found[n] = seek(*seekers[n], region, agents);
      }
    };
    forEachPiece(batch, seekPlaces, parallelFromSeekers, seekersPerChunk);
    // A lower share frees places that the later seekers have tried already: they begin again in a new batch.
    const double share = share_;
    for (std::size_t n = 0; n < batch && share_ == share; ++n) {
      Seeker& seeker = *seekers[n];
      bool isFree = found[n] && isFreeOf(placed, seeker, agents);
      while (!isFree) {
        if (seeker.tries % triesBeforeLowering == 0) share_ *= 0.99;
        isFree = seek(seeker, region, agents);
      }
      const Index index = agents.append(kind, seeker.place, seeker.radius);
      grid_.insert(index, seeker.place);
      placed.push_back(index);
    }
  }
}

}  // namespace restenosis

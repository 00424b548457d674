#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "tissue/agents/AgentShapes.h"
#include "tissue/agents/Lanes.h"
#include "tissue/agents/PlainArray.h"
#include "tissue/neighbours/CellGrid.h"
#include "tissue/neighbours/ContactNeighbour.h"

namespace restenosis {

/// Neighbours in a wall that goes on beyond the ends of the vessel as its own mirror image: in the planes z =
/// 0 and z = length. The agents must not change while it is in use.
class MirroredNeighbours {
 public:
  /// An agent, or its image, that a search found.
  struct Found {
    Index agent;
    double radius;    ///< [m]
    Vec3 offset;      ///< from the centre of the search to it [m]
    double distance;  ///< length of `offset` [m]
  };

  /// For neighbours within up to `range` (R1 + R2). `vesselLength` [m]; 0: no ends, no images.
  MirroredNeighbours(const AgentShapes& agents, double range, double vesselLength);
  /// The same with only some of the agents to be found.
  MirroredNeighbours(const AgentShapes& agents, std::span<const Index> some, double range,
                     double vesselLength);

  /// Calls f(found) for each agent and each image of one within `range` (radius + R_j) of `centre`. An agent
  /// at `centre` is among them. No stated order; several threads may ask.
  template <class F>
  void forEachWithin(double range, const Vec3& centre, double radius, F&& f) const {
    search(range, centre, radius, f);
    if (vesselLength_ <= 0) return;
    const double reach = range * (radius + radii_.largest);
    if (centre.z() < reach) searchImages(range, centre, 0.0, radius, f);
    if (vesselLength_ - centre.z() < reach) searchImages(range, centre, vesselLength_, radius, f);
  }

  /// Fills `found` with the neighbours of agent `i` within `range` (R1 + R2). The images of others are never
  /// nearer than they are themselves; its own image is a neighbour only where it does not overlap the agent:
  /// nearer to the plane the others' images go round the agent as they do inside the wall.
  void gather(Index i, double range, std::vector<ContactNeighbour>& found) const;

 private:
  /// So many distances are computed at once.
  static constexpr int lanes = 8;
  using Values = Numbers<double, lanes>;

  struct Radii {
    double sum = 0, largest = 0;  ///< [m]
    void join(const Radii& other) { sum += other.sum, largest = std::max(largest, other.largest); }
  };

  /// `agentAt(k)` the k-th of `count` agents to be found.
  template <class AgentAt>
  MirroredNeighbours(const AgentShapes& agents, std::size_t count, const AgentAt& agentAt, double range,
                     double vesselLength);

  template <class F>
  void search(double range, const Vec3& centre, double radius, F&& f) const {
    grid_.forEachCandidateRange(
        centre, range * (radius + radii_.largest), [&](std::uint32_t begin, std::uint32_t end) {
          for (std::uint32_t n = begin; n < end; n += lanes)
            tellThose(range, centre, radius, n, std::min<std::uint32_t>(end - n, lanes), f);
        });
  }
  /// Of `count` agents from place n on, at most `lanes`, those in range.
  template <class F>
  void tellThose(double range, const Vec3& centre, double radius, std::uint32_t n, std::uint32_t count,
                 F&& f) const {
    const Values dx = Values::from(x_.data() + n) - centre.x(), dy = Values::from(y_.data() + n) - centre.y(),
                 dz = Values::from(z_.data() + n) - centre.z();
    const Values reach = range * (Values::from(radius_.data() + n) + radius);
    const Values squared = dx * dx + dy * dy + dz * dz;
    for (unsigned bits = bitsOf(squared <= reach * reach) & ((1U << count) - 1); bits != 0;
         bits &= bits - 1) {
      const std::uint32_t k = n + static_cast<std::uint32_t>(std::countr_zero(bits));
      // Read again: from the lanes it would have to wait until they are stored
      const Vec3 offset = Vec3(x_.data()[k], y_.data()[k], z_.data()[k]) - centre;
      f(Found{.agent = agent_.data()[k],
              .radius = radius_.data()[k],
              .offset = offset,
              .distance = offset.norm()});
    }
  }
  /// Images in the plane at `plane` are as far from `centre` as the agents themselves are from its image.
  template <class F>
  void searchImages(double range, const Vec3& centre, double plane, double radius, F&& f) const {
    const Vec3 image(centre.x(), centre.y(), 2 * plane - centre.z());
    search(range, image, radius, [&f](Found found) {
      found.offset.z() = -found.offset.z();
      f(found);
    });
  }

  AgentShapes agents_;
  double vesselLength_;
  Radii radii_;  ///< of the agents to be found
  CellGrid grid_;
  /// In the order of the grid, so that a search reads few lines of memory: centre and radius [m].
  PlainArray<double> x_, y_, z_, radius_;
  PlainArray<Index> agent_;
};

}  // namespace restenosis

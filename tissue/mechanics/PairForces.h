#pragma once

#include <array>
#include <numbers>
#include <span>

#include "BondAttraction.h"
#include "Cohesion.h"
#include "ContactLaws.h"
#include "Lanes.h"
#include "Spheres.h"

namespace restenosis {

/// The force loop for one contact law and one precision: several agents at once, each lane gathering the
/// forces on its own agent, partner after partner. A lane's sums have the order of its partners whatever is
/// in the other lanes, and partners out of range add exact zeros, so neither the grouping nor the list
/// changes a bit of the result.
template <class Law, class Spheres>
class PairForces {
 public:
  static constexpr int lanes = Spheres::lanes;
  using Values = typename Spheres::Values;
  using Real = typename Values::Number;

  PairForces(const ForceInput& in, const Spheres& spheres)
      : pairs_(in.pairs),
        spheres_(spheres),
        law_(in.parameters.contactModulus),
        cohesion_{in.parameters.cohesionModulus, in.parameters.cohesionRange},
        attraction_{in.parameters.bondModulus, in.parameters.bondAxialFactor} {}

  /// Loads of the agents of group g.
  void group(std::size_t g, std::array<AgentLoad, laneCount>& loads) const {
    for (int first = 0; first < laneCount; first += lanes) {
      const bool apart =
          pairs_.marked(g) ? sum<true, false>(g, first, loads) : sum<false, false>(g, first, loads);
      if (!apart) [[unlikely]]
        sum<true, true>(g, first, loads);
    }
  }

 private:
  // Distance that coinciding centres are taken to have, over sqrt(3) [m]: far below any radius; its square is
  // far above underflow, in single precision too.
  static constexpr Real coincident = 1e-15F;

  /// The loads of the group's agents from the `first` on. `cohesive`: whether pairs may be marked for a
  /// daughter. Returns false, the loads being wrong, if centres coincide and `careful` is not set.
  template <bool cohesive, bool careful>
  bool sum(std::size_t g, int first, std::array<AgentLoad, laneCount>& loads) const {
    std::array<Index, lanes> self;
    const auto firstAgent = static_cast<Index>(g * laneCount) + static_cast<Index>(first);
    for (Index k = 0; k < self.size(); ++k) self[k] = std::min(firstAgent + k, pairs_.nobody());
    const auto here = spheres_.at(self.data());
    const bool allBondsAlike = attraction_.axialFactor == 1;
    Values fx = 0, fy = 0, fz = 0, virial = 0, stiffness = 0, nearest2 = Real{1};
    for (const PairTable::Block& block : pairs_.group(g)) {
      const auto there = spheres_.at(&block.partner[first]);
      Values dx, dy, dz;
      spheres_.separation(here, there, dx, dy, dz);
      Values distance2 = dx * dx + dy * dy + dz * dz;
      if constexpr (careful) {
        tellApart(self, &block.partner[first], dx, dy, dz, distance2);
      } else {
        nearest2 = nearest2.min(distance2);
      }
      const Values radii = here.r + there.r;
      const Values distance = distance2.sqrt();
      Values push, slope;
      law_.evaluate((radii - distance).max(0), here.r * there.r / radii, push, slope);
      stiffness += slope;

      Values rest;
      for (int k = 0; k < lanes; ++k) rest.set(k, block.rest[first + k]);
      // Where the direction does not matter the division is saved: the result is the same.
      const Values cosine = allBondsAlike ? Values(0) : dz / distance;
      Values pull;
      attraction_.evaluate(distance, rest.abs(), radii, cosine * cosine, pull, slope);
      push -= pull;
      stiffness += slope;

      if constexpr (cohesive) {
        cohesion_.evaluate(distance - radii, radii, pull, slope);
        push -= pull.where(rest < Real{0});
        stiffness += slope.where(rest < Real{0});
      }
      const Values overDistance = push / distance;
      fx += overDistance * dx;
      fy += overDistance * dy;
      fz += overDistance * dz;
      virial += push * distance;
    }
    bool apart = true;
    for (int k = 0; k < lanes; ++k) {
      apart &= nearest2[k] > 0;
      const double r = here.r[k];
      loads[first + k] = {fx[k], fy[k], fz[k],
                          virial[k] / (8 * std::numbers::pi * r * r * r),  // 2 (halves) x 3 (trace) x V
                          stiffness[k]};
    }
    return apart;
  }

  /// Gives coinciding centres a direction: the agent of lower index is pushed along (1, 1, 1) and the other
  /// against it, so that action equals reaction.
  static void tellApart(const std::array<Index, lanes>& self, const Index* other, Values& dx, Values& dy,
                        Values& dz, Values& distance2) {
    for (int k = 0; k < lanes; ++k) {
      if (distance2[k] != 0) continue;
      const Real side = self[k] < other[k] ? coincident : -coincident;
      dx.set(k, side), dy.set(k, side), dz.set(k, side);
      distance2.set(k, 3 * coincident * coincident);
    }
  }

  const PairTable& pairs_;
  const Spheres& spheres_;
  Law law_;
  Cohesion cohesion_;
  BondAttraction attraction_;
};

/// Sets loads[k] for every k-th agent of `subset`, which is ascending.
template <class Law, class Spheres>
void evaluatePairs(const ForceInput& in, const Spheres& spheres, std::span<const Index> subset,
                   std::span<AgentLoad> loads) {
  const PairForces<Law, Spheres> forces(in, spheres);
  std::array<AgentLoad, laneCount> ofGroup;
  for (std::size_t k = 0; k < subset.size();) {
    const std::size_t g = subset[k] / laneCount;
    forces.group(g, ofGroup);
    for (; k < subset.size() && subset[k] / laneCount == g; ++k) loads[k] = ofGroup[subset[k] % laneCount];
  }
}

}  // namespace restenosis

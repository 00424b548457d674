#pragma once

#include <algorithm>
#include <array>
#include <numbers>
#include <span>

#include "tissue/agents/Lanes.h"
#include "tissue/forces/AgentLoad.h"
#include "tissue/forces/BondAttraction.h"
#include "tissue/forces/Cohesion.h"
#include "tissue/forces/MechanicsParameters.h"
#include "tissue/forces/PairList.h"
#include "tissue/forces/Spheres.h"

namespace restenosis {

/// The pair kernel for one contact law and one precision: the loads of several agents at once, each lane
/// summing the pairs of its own agent in their order. Pairs out of range add exact zeros, so neither the
/// slicing nor the skin of the list changes a bit of the result. PlainPairKernel computes the same, one pair
/// after the other.
template <class Law, class Spheres>
class PairKernel {
 public:
  static constexpr int lanes = Spheres::lanes;
  using Values = typename Spheres::Values;
  using Real = typename Values::Number;

  PairKernel(const MechanicsParameters& parameters, const Spheres& spheres)
      : spheres_(spheres),
        law_(parameters.contactModulus),
        cohesion_{parameters.cohesionModulus, parameters.cohesionRange},
        attraction_{parameters.bondModulus, parameters.bondAxialFactor} {}

  /// Sets loads[k] for the k-th of `agents`, which have the pairs `list`.
  void evaluate(const PairList& list, std::span<const Index> agents, std::span<AgentLoad> loads) const {
    std::array<Index, lanes> self;
    std::array<AgentLoad, lanes> ofLanes;
    for (std::size_t first = 0; first < agents.size(); first += lanes) {
      const auto entries = list.entries(first / PairList::width);
      const auto attractions = list.attractions(first / PairList::width);
      const std::size_t lane = first % PairList::width;
      const std::size_t count = std::min<std::size_t>(lanes, agents.size() - first);
      for (std::size_t n = 0; n < count; ++n) self[n] = agents[list[first + n]];
      std::fill(self.begin() + count, self.end(), self[0]);  // lanes beyond the last have no pairs
      prefetchNext(list, agents, first + lanes);
      const Values nearest2 = sum<false>(entries, attractions, lane, self, ofLanes);
      if (nearest2.smallest() == 0) [[unlikely]]
        separate(entries, attractions, lane, self, nearest2, ofLanes);
      for (std::size_t n = 0; n < count; ++n) loads[list[first + n]] = ofLanes[n];
    }
  }

 private:
  static_assert(PairList::width % lanes == 0);

  // Partners are fetched so many entries before they are needed. Speed only: 3 to 9 % of relaxation where the
  // agents do not fit the caches, a loss of 2 % of this loop where they do.
  static constexpr std::size_t ahead = 3;

  // Distance that coinciding centres are assumed to have, over sqrt(3) [m]: far below any radius; its square
  // is far above underflow, in single precision too.
  static constexpr Real coincident = 1e-15F;

  /// Prefetches the agents of the next lanes, from `first` on, and their first partners.
  void prefetchNext(const PairList& list, std::span<const Index> agents, std::size_t first) const {
    for (std::size_t n = first; n < std::min<std::size_t>(first + lanes, agents.size()); ++n)
      spheres_.prefetchOne(agents[list[n]]);
    if (first >= agents.size()) return;
    const auto entries = list.entries(first / PairList::width);
    for (const auto& entry : entries.first(std::min(ahead, entries.size())))
      spheres_.prefetch(entry.partner.data() + first % PairList::width);
  }

  /// Sets the loads of those agents that coincide with a partner. Those of the others are left as they
  /// are: no bit of them may depend on the agents of other lanes.
  void separate(std::span<const PairList::Entry> entries, PairList::Attractions attractions, std::size_t lane,
                const std::array<Index, lanes>& self, const Values& nearest2,
                std::array<AgentLoad, lanes>& loads) const {
    std::array<AgentLoad, lanes> separated;
    sum<true>(entries, attractions, lane, self, separated);
    for (int k = 0; k < lanes; ++k)
      if (nearest2[k] == 0) loads[k] = separated[k];
  }

  /// Sets the loads of the agents `self`, their pairs beginning at `lane`. Returns the square of the distance
  /// of the nearest partner [m^2], or of a metre; where it is 0 the loads are right only if `separated` is
  /// set.
  template <bool separated>
  Values sum(std::span<const PairList::Entry> entries, PairList::Attractions attractions, std::size_t lane,
             const std::array<Index, lanes>& self, std::array<AgentLoad, lanes>& loads) const {
    const auto here = spheres_.at(self.data());
    const bool isotropic = attraction_.axialFactor == 1;
    Values fx = 0, fy = 0, fz = 0, virial = 0, stiffness = 0, nearest2 = Real{1};
    for (std::size_t n = 0; n < entries.size(); ++n) {
      const Index* const partners = entries[n].partner.data() + lane;
      if (n + ahead < entries.size()) spheres_.prefetch(entries[n + ahead].partner.data() + lane);
      const auto there = spheres_.at(partners);
      Values dx, dy, dz;
      spheres_.separation(here, there, dx, dy, dz);
      Values distance2 = dx * dx + dy * dy + dz * dz;
      if constexpr (separated) {
        separateCoinciding(self, partners, dx, dy, dz, distance2);
      } else {
        nearest2 = nearest2.min(distance2);
      }
      const Values radii = here.r + there.r;
      const Values distance = distance2.sqrt();
      Values push, pull, slope;
      law_.evaluate((radii - distance).max(0), here.r * there.r / radii, push, slope);
      stiffness += slope;

      const Values rest = Values::from(entries[n].restLength.data() + lane);
      if (attractions.bonds) {
        // Where the direction does not matter the division is saved: the result is the same.
        const Values cosine = isotropic ? Values(0) : dz / distance;
        attraction_.evaluate(distance, rest.abs(), radii, cosine * cosine, pull, slope);
        push -= pull;
        stiffness += slope;
      }
      if (attractions.cohesion) {
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
    for (int k = 0; k < lanes; ++k) {
      const double r = here.r[k];
      loads[k] = {fx[k], fy[k], fz[k],
                  virial[k] / (8 * std::numbers::pi * r * r * r),  // 2 (halves) x 3 (trace) x V
                  stiffness[k]};
    }
    return nearest2;
  }

  /// Gives coinciding centres a direction: the agent of lower index is pushed along (1, 1, 1) and the other
  /// against it, so that action equals reaction.
  static void separateCoinciding(const std::array<Index, lanes>& self, const Index* other, Values& dx,
                                 Values& dy, Values& dz, Values& distance2) {
    for (int k = 0; k < lanes; ++k) {
      if (distance2[k] != 0) continue;
      const Real side = self[k] < other[k] ? coincident : -coincident;
      dx.set(k, side), dy.set(k, side), dz.set(k, side);
      distance2.set(k, 3 * coincident * coincident);
    }
  }

  const Spheres& spheres_;
  Law law_;
  Cohesion cohesion_;
  BondAttraction attraction_;
};

/// Sets loads[k] for the k-th of `agents`, which have the pairs `list`; in the calling thread.
template <class Law, class Spheres>
void evaluatePairs(const MechanicsParameters& parameters, const Spheres& spheres, const PairList& list,
                   std::span<const Index> agents, std::span<AgentLoad> loads) {
  PairKernel<Law, Spheres>(parameters, spheres).evaluate(list, agents, loads);
}

}  // namespace restenosis

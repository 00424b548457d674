#pragma once

#include <algorithm>
#include <array>
#include <numbers>
#include <span>

#include "tissue/agents/Lanes.h"
#include "tissue/forces/BondAttraction.h"
#include "tissue/forces/Cohesion.h"
#include "tissue/forces/ContactLaws.h"
#include "tissue/forces/PairRows.h"
#include "tissue/forces/Spheres.h"

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

  PairForces(const MechanicsParameters& parameters, const Spheres& spheres)
      : spheres_(spheres),
        law_(parameters.contactModulus),
        cohesion_{parameters.cohesionModulus, parameters.cohesionRange},
        attraction_{parameters.bondModulus, parameters.bondAxialFactor} {}

  /// Sets loads[k] for the k-th of `agents`, whose rows are `rows`.
  void evaluate(const PairRows& rows, std::span<const Index> agents, std::span<AgentLoad> loads) const {
    std::array<Index, lanes> self;
    std::array<AgentLoad, lanes> ofLanes;
    for (std::size_t first = 0; first < agents.size(); first += lanes) {
      const std::size_t group = first / PairRows::width, lane = first % PairRows::width;
      const std::size_t count = std::min<std::size_t>(lanes, agents.size() - first);
      for (std::size_t n = 0; n < count; ++n) self[n] = agents[rows[first + n]];
      std::fill(self.begin() + count, self.end(), self[0]);  // lanes beyond the last have rows of nobody
      fetchNext(rows, agents, first + lanes);
      if (!sumOf<false>(rows, group, lane, self, ofLanes)) [[unlikely]]
        sumOf<true>(rows, group, lane, self, ofLanes);
      for (std::size_t n = 0; n < count; ++n) loads[rows[first + n]] = ofLanes[n];
    }
  }

 private:
  static_assert(PairRows::width % lanes == 0);

  // Partners are asked for so many lines before they are needed. Speed only: 3 to 9 % of relaxation where the
  // agents do not fit the caches, a loss of 2 % of this loop where they do.
  static constexpr std::size_t ahead = 3;

  // Distance that coinciding centres are taken to have, over sqrt(3) [m]: far below any radius; its square is
  // far above underflow, in single precision too.
  static constexpr Real coincident = 1e-15F;

  /// Asks for the agents from `first` on that stand in the next lanes, and for their first partners.
  void fetchNext(const PairRows& rows, std::span<const Index> agents, std::size_t first) const {
    for (std::size_t n = first; n < std::min<std::size_t>(first + lanes, agents.size()); ++n)
      spheres_.fetchOne(agents[rows[n]]);
    if (first >= agents.size()) return;
    const auto lines = rows.partners(first / PairRows::width);
    for (const auto& line : lines.first(std::min(ahead, lines.size())))
      spheres_.fetch(line.agent.data() + first % PairRows::width);
  }

  /// The loads of the agents `self`, whose rows begin at `lane` of this group. Returns false, the loads being
  /// wrong, if centres coincide and `careful` is not set.
  template <bool careful>
  bool sumOf(const PairRows& rows, std::size_t group, std::size_t lane, const std::array<Index, lanes>& self,
             std::array<AgentLoad, lanes>& loads) const {
    switch (rows.kind(group)) {
      case PairRows::Kind::unmarked:
        return sum<PairRows::Kind::unmarked, careful>(rows, group, lane, self, loads);
      case PairRows::Kind::mixed:
        return sum<PairRows::Kind::mixed, careful>(rows, group, lane, self, loads);
      default:
        return sum<PairRows::Kind::marked, careful>(rows, group, lane, self, loads);
    }
  }
  template <PairRows::Kind kind, bool careful>
  bool sum(const PairRows& rows, std::size_t group, std::size_t lane, const std::array<Index, lanes>& self,
           std::array<AgentLoad, lanes>& loads) const {
    constexpr bool bonded = kind != PairRows::Kind::marked;
    const auto lines = rows.partners(group);
    const auto rests = rows.rests(group);
    const auto here = spheres_.at(self.data());
    const bool allBondsAlike = attraction_.axialFactor == 1;
    Values fx = 0, fy = 0, fz = 0, virial = 0, stiffness = 0, nearest2 = Real{1};
    for (std::size_t n = 0; n < lines.size(); ++n) {
      const Index* const partners = lines[n].agent.data() + lane;
      if (n + ahead < lines.size()) spheres_.fetch(lines[n + ahead].agent.data() + lane);
      const auto there = spheres_.at(partners);
      Values dx, dy, dz;
      spheres_.separation(here, there, dx, dy, dz);
      Values distance2 = dx * dx + dy * dy + dz * dz;
      if constexpr (careful) {
        tellApart(self, partners, dx, dy, dz, distance2);
      } else {
        nearest2 = nearest2.min(distance2);
      }
      const Values radii = here.r + there.r;
      const Values distance = distance2.sqrt();
      Values push, slope;
      law_.evaluate((radii - distance).max(0), here.r * there.r / radii, push, slope);
      stiffness += slope;

      Values pull;
      if constexpr (bonded) {
        const Values rest = Values::from(rests[n].length.data() + lane);
        // Where the direction does not matter the division is saved: the result is the same.
        const Values cosine = allBondsAlike ? Values(0) : dz / distance;
        attraction_.evaluate(distance, rest.abs(), radii, cosine * cosine, pull, slope);
        push -= pull;
        stiffness += slope;
        if constexpr (kind == PairRows::Kind::mixed) {
          cohesion_.evaluate(distance - radii, radii, pull, slope);
          push -= pull.where(rest < Real{0});
          stiffness += slope.where(rest < Real{0});
        }
      } else {
        cohesion_.evaluate(distance - radii, radii, pull, slope);
        push -= pull;
        stiffness += slope;
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
      loads[k] = {fx[k], fy[k], fz[k],
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

  const Spheres& spheres_;
  Law law_;
  Cohesion cohesion_;
  BondAttraction attraction_;
};

/// Sets loads[k] for the k-th of `agents`, whose rows are `rows`; in the calling thread.
template <class Law, class Spheres>
void evaluatePairs(const MechanicsParameters& parameters, const Spheres& spheres, const PairRows& rows,
                   std::span<const Index> agents, std::span<AgentLoad> loads) {
  PairForces<Law, Spheres>(parameters, spheres).evaluate(rows, agents, loads);
}

}  // namespace restenosis

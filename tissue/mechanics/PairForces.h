#pragma once

#include <algorithm>
#include <array>
#include <limits>
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
      std::array<Index, lanes> self;
      for (int k = 0; k < lanes; ++k)
        self[k] =
            std::min(static_cast<Index>(g * laneCount) + static_cast<Index>(first + k), pairs_.nobody());
      evaluate(GroupRows{pairs_.group(g), first}, self, pairs_.marked(g), loads.data() + first);
    }
  }

  /// Loads of any agents, for `lanes` of them that stand apart.
  void apart(const std::array<Index, lanes>& agents, std::array<AgentLoad, lanes>& loads) const {
    evaluate(ApartRows(pairs_, agents), agents, true, loads.data());
  }

 private:
  /// The rows of agents that follow each other.
  struct GroupRows {
    std::span<const PairTable::Block> blocks;
    int first;

    std::size_t size() const { return blocks.size(); }
    const Index* partners(std::size_t n, std::array<Index, lanes>&) const {
      return &blocks[n].partner[first];
    }
    float rest(std::size_t n, int lane) const { return blocks[n].rest[first + lane]; }
  };

  /// The rows of agents from anywhere, each as long as that of its group.
  class ApartRows {
   public:
    ApartRows(const PairTable& pairs, const std::array<Index, lanes>& agents) : nobody_(pairs.nobody()) {
      for (int k = 0; k < lanes; ++k) {
        rows_[k] = pairs.group(agents[k] / laneCount);
        lane_[k] = static_cast<int>(agents[k] % laneCount);
        size_ = std::max(size_, rows_[k].size());
      }
    }
    std::size_t size() const { return size_; }
    const Index* partners(std::size_t n, std::array<Index, lanes>& scratch) const {
      for (int k = 0; k < lanes; ++k)
        scratch[k] = n < rows_[k].size() ? rows_[k][n].partner[lane_[k]] : nobody_;
      return scratch.data();
    }
    float rest(std::size_t n, int lane) const {
      return n < rows_[lane].size() ? rows_[lane][n].rest[lane_[lane]]
                                    : std::numeric_limits<float>::infinity();
    }

   private:
    std::array<std::span<const PairTable::Block>, lanes> rows_;
    std::array<int, lanes> lane_;
    std::size_t size_ = 0;
    Index nobody_;
  };

  /// `cohesive`: whether pairs may be marked for a daughter; true is never wrong.
  template <class Rows>
  void evaluate(const Rows& rows, const std::array<Index, lanes>& self, bool cohesive,
                AgentLoad* loads) const {
    const bool apart = cohesive ? sum<true, false>(rows, self, loads) : sum<false, false>(rows, self, loads);
    if (!apart) [[unlikely]]
      sum<true, true>(rows, self, loads);
  }

  // Distance that coinciding centres are taken to have, over sqrt(3) [m]: far below any radius; its square is
  // far above underflow, in single precision too.
  static constexpr Real coincident = 1e-15F;

  /// The loads of the agents `self`. Returns false, the loads being wrong, if centres coincide and `careful`
  /// is not set.
  template <bool cohesive, bool careful, class Rows>
  bool sum(const Rows& rows, const std::array<Index, lanes>& self, AgentLoad* loads) const {
    std::array<Index, lanes> scratch;
    const auto here = spheres_.at(self.data());
    const bool allBondsAlike = attraction_.axialFactor == 1;
    Values fx = 0, fy = 0, fz = 0, virial = 0, stiffness = 0, nearest2 = Real{1};
    for (std::size_t n = 0; n < rows.size(); ++n) {
      const Index* partners = rows.partners(n, scratch);
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

      Values rest;
      for (int k = 0; k < lanes; ++k) rest.set(k, rows.rest(n, k));
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

  const PairTable& pairs_;
  const Spheres& spheres_;
  Law law_;
  Cohesion cohesion_;
  BondAttraction attraction_;
};

/// Sets loads[k] for every k-th agent of `subset`, which is ascending. Where few of a group are wanted they
/// are computed together with others that stand apart.
template <class Law, class Spheres>
void evaluatePairs(const ForceInput& in, const Spheres& spheres, std::span<const Index> subset,
                   std::span<AgentLoad> loads) {
  using Forces = PairForces<Law, Spheres>;
  constexpr std::size_t lanes = Forces::lanes;
  const Forces forces(in, spheres);
  std::array<AgentLoad, laneCount> ofGroup;
  std::array<Index, lanes> apart;
  std::array<std::size_t, lanes> place;
  std::array<AgentLoad, lanes> ofApart;
  std::size_t waiting = 0;
  const auto finishWaiting = [&] {
    std::fill(apart.begin() + waiting, apart.end(), apart[0]);
    forces.apart(apart, ofApart);
    for (std::size_t k = 0; k < waiting; ++k) loads[place[k]] = ofApart[k];
    waiting = 0;
  };
  for (std::size_t k = 0; k < subset.size();) {
    const std::size_t g = subset[k] / laneCount;
    std::size_t end = k;
    while (end < subset.size() && subset[end] / laneCount == g) ++end;
    if (end - k < laneCount / 2) {
      for (; k < end; ++k) {
        apart[waiting] = subset[k];
        place[waiting] = k;
        if (++waiting == lanes) finishWaiting();
      }
    } else {
      forces.group(g, ofGroup);
      for (; k < end; ++k) loads[k] = ofGroup[subset[k] % laneCount];
    }
  }
  if (waiting > 0) finishWaiting();
}

}  // namespace restenosis

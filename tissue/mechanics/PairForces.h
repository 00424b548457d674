#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <numbers>
#include <ranges>
#include <span>

#include "AlikeRows.h"
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

  /// Loads of any agents, one a lane.
  void evaluate(const std::array<Index, lanes>& agents, std::array<AgentLoad, lanes>& loads) const {
    const bool cohesive = std::ranges::any_of(agents, [this](Index i) { return pairs_.marked(i); });
    const bool apart = cohesive ? sum<true, false>(agents, loads) : sum<false, false>(agents, loads);
    if (!apart) [[unlikely]]
      sum<true, true>(agents, loads);
  }

 private:
  using Block = PairTable::Block;
  static constexpr int width = PairTable::width;

  /// The rows of the lanes' agents, a block of each at a time.
  class Rows {
   public:
    Rows(const PairTable& pairs, const std::array<Index, lanes>& agents) {
      none_.partner.fill(pairs.nobody());
      none_.rest.fill(std::numeric_limits<float>::infinity());
      for (int k = 0; k < lanes; ++k) {
        length_[k] = pairs.length(agents[k]);
        row_[k] = pairs.row(agents[k]);
        longest_ = std::max(longest_, length_[k]);
      }
    }
    std::uint32_t size() const { return longest_; }
    /// The block of each lane that holds its partner n.
    std::array<const Block*, lanes> blocks(std::uint32_t n) const {
      std::array<const Block*, lanes> of;
      for (int k = 0; k < lanes; ++k) of[k] = n < length_[k] ? row_[k] + n / width : &none_;
      return of;
    }

   private:
    Block none_;
    std::array<std::uint32_t, lanes> length_;
    std::array<const Block*, lanes> row_;
    std::uint32_t longest_ = 0;
  };

  // Distance that coinciding centres are taken to have, over sqrt(3) [m]: far below any radius; its square is
  // far above underflow, in single precision too.
  static constexpr Real coincident = 1e-15F;

  /// The loads of the agents `self`. Returns false, the loads being wrong, if centres coincide and `careful`
  /// is not set.
  template <bool cohesive, bool careful>
  bool sum(const std::array<Index, lanes>& self, std::array<AgentLoad, lanes>& loads) const {
    const Rows rows(pairs_, self);
    std::array<const Block*, lanes> blocks{};
    std::array<Values, width> rests;
    const auto here = spheres_.at(self.data());
    const bool allBondsAlike = attraction_.axialFactor == 1;
    Values fx = 0, fy = 0, fz = 0, virial = 0, firmness = 0, stiffness = 0, nearest2 = Real{1};
    for (std::uint32_t n = 0; n < rows.size(); ++n) {
      if (n % width == 0) {
        blocks = rows.blocks(n);
        transpose<float>([&](int k) { return blocks[k]->rest.data(); }, rests);
      }
      std::array<Index, lanes> partners;
      for (int k = 0; k < lanes; ++k) partners[k] = blocks[k]->partner[n % width];
      const auto there = spheres_.at(partners.data());
      Values dx, dy, dz;
      spheres_.separation(here, there, dx, dy, dz);
      Values distance2 = dx * dx + dy * dy + dz * dz;
      if constexpr (careful) {
        tellApart(self, partners.data(), dx, dy, dz, distance2);
      } else {
        nearest2 = nearest2.min(distance2);
      }
      const Values radii = here.r + there.r;
      const Values distance = distance2.sqrt();
      Values push, slope;
      law_.evaluate((radii - distance).max(0), here.r * there.r / radii, push, slope);
      firmness += slope;
      stiffness += slope;

      const Values rest = rests[n % width];
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
      loads[k] = {fx[k],
                  fy[k],
                  fz[k],
                  virial[k] / (8 * std::numbers::pi * r * r * r),  // 2 (halves) x 3 (trace) x V
                  stiffness[k],
                  firmness[k]};
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

/// Sets loads[k] for every k-th agent of `subset`, in ascending order. Agents next to each other in the store
/// should be so in space (spatialOrder): this decides speed, no result.
template <class Law, class Spheres>
void evaluatePairs(const ForceInput& in, const Spheres& spheres, std::span<const Index> subset,
                   std::span<AgentLoad> loads) {
  using Forces = PairForces<Law, Spheres>;
  constexpr std::size_t lanes = Forces::lanes;
  const Forces forces(in, spheres);
  std::array<Index, lanes> agents;
  std::array<AgentLoad, lanes> ofLanes;
  for (std::size_t begin = 0; begin < subset.size(); begin += AlikeRows::most) {
    const auto piece = subset.subspan(begin, std::min(AlikeRows::most, subset.size() - begin));
    const AlikeRows order(in.pairs, piece);
    for (std::size_t first = 0; first < piece.size(); first += lanes) {
      const std::size_t count = std::min(lanes, piece.size() - first);
      for (std::size_t n = 0; n < count; ++n) agents[n] = piece[order[first + n]];
      std::fill(agents.begin() + count, agents.end(), agents[0]);
      forces.evaluate(agents, ofLanes);
      for (std::size_t n = 0; n < count; ++n) loads[begin + order[first + n]] = ofLanes[n];
    }
  }
}

}  // namespace restenosis

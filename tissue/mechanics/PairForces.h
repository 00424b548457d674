#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <span>

#include "BondAttraction.h"
#include "Chunks.h"
#include "Cohesion.h"
#include "ContactLaws.h"
#include "Lanes.h"

namespace restenosis {

/// Pairs of one agent that act on each other, collected for computing them in groups.
class PairBatch {
 public:
  static constexpr int capacity = 64;

  bool full() const { return count_ == capacity; }
  bool empty() const { return count_ == 0; }
  int count() const { return count_; }

  /// Takes a pair if `acts`. (dx, dy, dz): from the other agent to this one; `a`, `b`: what the force depends
  /// on besides the distance. Centres that coincide are told apart by `lower`, true for the agent of lower
  /// index: it is pushed along a fixed direction and the other against it, so that action equals reaction.
  void add(bool acts, double dx, double dy, double dz, double distance2, double a, double b, bool lower) {
    if (acts && distance2 == 0) [[unlikely]] {
      dx = dy = dz = (lower ? 1 : -1) * coincident;
      distance2 = 3 * coincident * coincident;
    }
    dx_[count_] = dx, dy_[count_] = dy, dz_[count_] = dz;
    distance2_[count_] = distance2, a_[count_] = a, b_[count_] = b;
    count_ += acts;
  }

  /// Computes all pairs with law(distance, dz, a, b, push, stiffness), push > 0 repelling, adds them to
  /// `load` in the order they came, and empties the batch. Until the sum is complete, load.pressure is the
  /// sum of push x distance.
  template <class Law>
  void flush(AgentLoad& load, Law&& law) {
    // The lanes that fill the last group repeat its first pair.
    const int first = count_ / laneCount * laneCount;
    for (int k = count_; k % laneCount != 0; ++k) {
      dx_[k] = dx_[first], dy_[k] = dy_[first], dz_[k] = dz_[first];
      distance2_[k] = distance2_[first], a_[k] = a_[first], b_[k] = b_[first];
    }
    for (int k = 0; k < count_; k += laneCount) {
      const Lanes distance = lanes(distance2_, k).sqrt();
      Lanes push, stiffness;
      law(distance, Lanes(lanes(dz_, k)), Lanes(lanes(a_, k)), Lanes(lanes(b_, k)), push, stiffness);
      lanes(a_, k) = push / distance;
      lanes(b_, k) = stiffness;
    }
    for (int k = 0; k < count_; ++k) {
      load.fx += a_[k] * dx_[k];
      load.fy += a_[k] * dy_[k];
      load.fz += a_[k] * dz_[k];
      load.pressure += a_[k] * distance2_[k];
      load.stiffness += b_[k];
    }
    count_ = 0;
  }

 private:
  // Distance that coinciding centres are taken to have, over sqrt(3) [m]: far below any radius, far above
  // underflow.
  static constexpr double coincident = 1e-20;

  using Column = std::array<double, capacity + laneCount>;
  static auto lanes(Column& column, int k) { return Eigen::Map<Lanes>(column.data() + k); }

  Column dx_, dy_, dz_, distance2_, a_, b_;
  int count_ = 0;
};

/// The force loop for one contact law: contacts over the neighbours, cohesion over the neighbours, then
/// bonds.
template <class Law>
class PairForces {
 public:
  explicit PairForces(const ForceInput& in)
      : in_(in),
        law_(in.parameters.contactModulus),
        cohesion_{in.parameters.cohesionModulus, in.parameters.cohesionRange},
        attraction_{in.parameters.bondModulus, in.parameters.bondAxialFactor} {}

  AgentLoad of(Index i) const {
    const Sphere self = in_.spheres[i];
    AgentLoad load;
    addContacts(i, self, load);
    addCohesion(i, self, load);
    addBonds(i, self, load);
    load.pressure /= 8 * std::numbers::pi * self.r * self.r * self.r;  // 2 (halves) x 3 (trace) x V
    return load;
  }

 private:
  void addContacts(Index i, const Sphere& self, AgentLoad& load) const {
    const auto contact = [this](const Lanes& distance, const Lanes&, const Lanes& sum, const Lanes& product,
                                Lanes& push, Lanes& stiffness) {
      // Rounding of the distance can make the overlap of a pair that just touches negative.
      law_.evaluate(Lanes((sum - distance).max(0.0)), Lanes(product / sum), push, stiffness);
    };
    PairBatch batch;
    std::array<Index, PairBatch::capacity> touching;
    const std::span<const Index> near = in_.neighbours.of(i);
    for (std::size_t begin = 0; begin < near.size(); begin += touching.size()) {
      // Most listed agents do not touch: they are sorted out without a branch, and before anything is stored.
      const auto piece = near.subspan(begin, std::min(touching.size(), near.size() - begin));
      int count = 0;
      for (const Index j : piece) {
        const Sphere& other = in_.spheres[j];
        const double dx = self.x - other.x, dy = self.y - other.y, dz = self.z - other.z;
        const double sum = self.r + other.r;
        touching[count] = j;
        count += dx * dx + dy * dy + dz * dz < sum * sum;
      }
      for (int k = 0; k < count; ++k) {
        const Index j = touching[k];
        const Sphere& other = in_.spheres[j];
        const double dx = self.x - other.x, dy = self.y - other.y, dz = self.z - other.z;
        batch.add(true, dx, dy, dz, dx * dx + dy * dy + dz * dz, self.r + other.r, self.r * other.r, i < j);
        // Only when full, so that where a pair stands in a group does not depend on the list.
        if (batch.full()) batch.flush(load, contact);
      }
    }
    batch.flush(load, contact);
  }

  void addCohesion(Index i, const Sphere& self, AgentLoad& load) const {
    if (cohesion_.modulus == 0) return;
    const bool daughter = in_.flags[i] & AgentFlag::daughter;
    const auto cohesion = [this](const Lanes& distance, const Lanes&, const Lanes& sum, const Lanes&,
                                 Lanes& push, Lanes& stiffness) {
      for (int k = 0; k < laneCount; ++k) {
        push[k] = -cohesion_.pull(distance[k] - sum[k], sum[k]);
        stiffness[k] = cohesion_.stiffness(sum[k]);
      }
    };
    PairBatch batch;
    for (const Index j : in_.neighbours.of(i)) {
      if (!daughter && !(in_.flags[j] & AgentFlag::daughter)) continue;
      const Sphere& other = in_.spheres[j];
      const double dx = self.x - other.x, dy = self.y - other.y, dz = self.z - other.z;
      const double sum = self.r + other.r, end = cohesion_.range * sum,
                   distance2 = dx * dx + dy * dy + dz * dz;
      batch.add(distance2 > sum * sum && distance2 < end * end, dx, dy, dz, distance2, sum, 0, i < j);
      if (batch.full()) batch.flush(load, cohesion);
    }
    batch.flush(load, cohesion);
  }

  void addBonds(Index i, const Sphere& self, AgentLoad& load) const {
    if (attraction_.modulus == 0) return;
    const auto bond = [this](const Lanes& distance, const Lanes& dz, const Lanes& rest, const Lanes& sum,
                             Lanes& push, Lanes& stiffness) {
      // Where the direction does not matter the division is saved: the result is the same.
      const Lanes cosine = attraction_.axialFactor == 1 ? Lanes(0.0) : Lanes(dz / distance);
      Lanes pull;
      attraction_.evaluate(distance, rest, sum, Lanes(cosine * cosine), pull, stiffness);
      push = -pull;
    };
    PairBatch batch;
    for (const Bond& b : in_.bonds.of(i)) {
      const Sphere& other = in_.spheres[b.partner];
      const double dx = self.x - other.x, dy = self.y - other.y, dz = self.z - other.z;
      const double rest = b.restLength, distance2 = dx * dx + dy * dy + dz * dz;
      batch.add(distance2 > rest * rest, dx, dy, dz, distance2, rest, self.r + other.r, i < b.partner);
    }
    batch.flush(load, bond);
  }

  const ForceInput& in_;
  Law law_;
  Cohesion cohesion_;
  BondAttraction attraction_;
};

/// Sets load[i] for every i in `subset`.
template <class Law>
void evaluatePairs(const ForceInput& in, std::span<const Index> subset, std::span<AgentLoad> load) {
  const PairForces<Law> forces(in);
  forEachInChunks(subset.size(), [&](std::size_t k) { load[subset[k]] = forces.of(subset[k]); });
}

}  // namespace restenosis

#pragma once

#include <cmath>
#include <numbers>

#include "BondAttraction.h"
#include "Chunks.h"
#include "Cohesion.h"
#include "ContactLaws.h"

namespace restenosis {

/// Unit vector from `other` to `self` and their distance. Centres that coincide are told apart by index, the
/// lower one being pushed along a fixed direction and the higher against it, so that action still equals
/// reaction.
struct Branch {
  Branch(const Sphere& self, const Sphere& other, bool selfIsLower)
      : x(self.x - other.x),
        y(self.y - other.y),
        z(self.z - other.z),
        distance(std::sqrt(x * x + y * y + z * z)) {
    if (distance > 0) {
      const double inverse = 1 / distance;
      x *= inverse, y *= inverse, z *= inverse;
    } else {
      const double component = (selfIsLower ? 1 : -1) / std::numbers::sqrt3;
      x = y = z = component;
    }
  }
  double x, y, z, distance;
};

/// Adds the pair forces on an agent.
struct LoadSum {
  AgentLoad load;

  /// `push` > 0 repels.
  void add(const Branch& branch, double push, double stiffness) {
    load.fx += push * branch.x;
    load.fy += push * branch.y;
    load.fz += push * branch.z;
    load.pressure += push * branch.distance;
    load.stiffness += stiffness;
  }
  /// Turns the sum of push x distance into the pressure.
  AgentLoad of(double radius) const {
    AgentLoad result = load;
    result.pressure /= 8 * std::numbers::pi * radius * radius * radius;  // 2 (halves) x 3 (trace) x V
    return result;
  }
};

/// The force loop for one contact law: contacts and cohesion over the neighbours, then bonds.
template <class Law>
void evaluatePairs(const ForceInput& in, std::span<const Index> subset, std::span<AgentLoad> load) {
  const auto& p = in.parameters;
  const Law law(p.contactModulus);
  const Cohesion cohesion{p.cohesionModulus, p.cohesionRange};
  const BondAttraction attraction{p.bondModulus, p.bondAxialFactor};

  forEachInChunks(subset.size(), [&](std::size_t k) {
    const Index i = subset[k];
    const Sphere self = in.spheres[i];
    const bool daughter = in.flags[i] & AgentFlag::daughter;
    LoadSum sum;
    for (const Index j : in.neighbours.of(i)) {
      const Sphere& other = in.spheres[j];
      const double dx = self.x - other.x, dy = self.y - other.y, dz = self.z - other.z;
      const double radii = self.r + other.r;
      const double distance2 = dx * dx + dy * dy + dz * dz;
      if (distance2 < radii * radii) {
        const Branch branch(self, other, i < j);
        const double overlap = radii - branch.distance;
        if (overlap <= 0) continue;
        const double reduced = self.r * other.r / radii;
        sum.add(branch, law.force(overlap, reduced), law.stiffness(overlap, reduced));
      } else if (daughter || (in.flags[j] & AgentFlag::daughter)) {
        const Branch branch(self, other, i < j);
        const double pull = cohesion.pull(branch.distance - radii, radii);
        if (pull > 0) sum.add(branch, -pull, cohesion.stiffness(radii));
      }
    }
    for (const Bond& bond : in.bonds.of(i)) {
      const Sphere& other = in.spheres[bond.partner];
      const Branch branch(self, other, i < bond.partner);
      const double radii = self.r + other.r, rest = bond.restLength;
      const double pull = attraction.pull(branch.distance, rest, radii, branch.z * branch.z);
      if (pull > 0) sum.add(branch, -pull, attraction.stiffness(rest, radii, branch.z * branch.z));
    }
    load[i] = sum.of(self.r);
  });
}

}  // namespace restenosis

#include "tissue/stent/TissueStrain.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "tissue/agents/Chunks.h"
#include "tissue/neighbours/CellGrid.h"
#include "tissue/neighbours/NeighbourQuery.h"

namespace restenosis {
namespace {

using Mat3 = Eigen::Matrix3d;

// Neighbours within so many times the sum of the radii: some forty.
constexpr double range = 2;

}  // namespace

std::vector<double> strainAroundVessel(const AgentStore& agents, std::span<const double> packedPlaces) {
  const std::size_t count = packedPlaces.size() / 3;
  std::vector<double> strain(agents.size(), 0.0);
  if (count == 0) return strain;
  const auto packed = [&](std::size_t i) { return Vec3(packedPlaces.data() + 3 * i); };
  const double largestRadius = *std::ranges::max_element(agents.radius);
  const CellGrid grid(count, packed, 2 * range * largestRadius);
  forEachInChunks(count, [&](std::size_t i) {
    const Vec3 there = packed(i), here = agents.position(static_cast<Index>(i));
    const Vec3 around = Vec3(-there.y(), there.x(), 0).normalized();
    Mat3 present = Mat3::Zero(), before = Mat3::Zero();
    grid.forEachCandidate(there, range * (agents.radius[i] + largestRadius), [&](Index j) {
      const Vec3 apart = packed(j) - there;
      const double reach = range * (agents.radius[i] + agents.radius[j]);
      if (j == i || apart.squaredNorm() > reach * reach) return;
      present += (agents.position(j) - here) * apart.transpose();
      before += apart * apart.transpose();
    });
    // Neighbours in a plane, or fewer than three, leave the matrix singular
    constexpr double negligible = 1e-6;
    const Eigen::FullPivLU<Mat3> inverse = Eigen::FullPivLU<Mat3>().setThreshold(negligible).compute(before);
    if (inverse.isInvertible()) strain[i] = (present * inverse.solve(around)).norm() - 1;
  });
  return strain;
}

}  // namespace restenosis

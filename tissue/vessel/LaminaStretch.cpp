#include "LaminaStretch.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace restenosis {
namespace {

/// Bonds of a patch of the sheet: the vectors along them, and rest lengths.
struct Patch {
  Eigen::Matrix3Xd vectors;
  Eigen::ArrayXd restLength;
};

/// The bonds of the agent and of those it is bonded with, within the sheet.
Patch patchAbout(const Wall& wall, Index centre) {
  const AgentStore& agents = wall.agents;
  std::vector<Vec3> vectors;
  std::vector<double> restLengths;
  const auto addBondsOf = [&](Index i) {
    for (const Bond& bond : wall.bonds.of(i)) {
      if (agents.kind[bond.partner] != AgentKind::iel) continue;
      vectors.push_back(agents.position(bond.partner) - agents.position(i));
      restLengths.push_back(bond.restLength);
    }
  };
  addBondsOf(centre);
  for (const Bond& bond : wall.bonds.of(centre))
    if (agents.kind[bond.partner] == AgentKind::iel) addBondsOf(bond.partner);
  const auto count = static_cast<Eigen::Index>(vectors.size());
  Patch patch{Eigen::Matrix3Xd(3, count), Eigen::ArrayXd(count)};
  for (Eigen::Index k = 0; k < count; ++k) {
    patch.vectors.col(k) = vectors[static_cast<std::size_t>(k)];
    patch.restLength[k] = restLengths[static_cast<std::size_t>(k)];
  }
  return patch;
}

double largestPrincipalStrain(const Patch& patch) {
  if (patch.restLength.size() == 0) return 0;
  const Eigen::Matrix3d inertia = patch.vectors * patch.vectors.transpose();
  // Eigenvalues come in rising order: the plane of the bonds is that of the last two directions.
  const Eigen::Matrix<double, 3, 2> plane =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(inertia).eigenvectors().rightCols<2>();
  const Eigen::MatrixX2d flat = (plane.transpose() * patch.vectors).colwise().normalized().transpose();
  const auto u = flat.col(0).array(), v = flat.col(1).array();
  Eigen::MatrixX3d system(flat.rows(), 3);
  system.col(0) = 2 * u * u;
  system.col(1) = 4 * u * v;
  system.col(2) = 2 * v * v;
  const Eigen::ArrayXd ratio = patch.restLength / patch.vectors.colwise().norm().transpose().array();
  // The solution of least norm where the bonds are too few or too much alike to tell.
  const Eigen::Vector3d e = system.completeOrthogonalDecomposition().solve((1 - ratio * ratio).matrix());
  const double largest = 0.5 * (e[0] + e[2]) + std::hypot(0.5 * (e[0] - e[2]), e[1]);
  constexpr double tenfold = 0.5 * (1 - 0.01);  // as far as a fit can be taken at its word
  return 1 / std::sqrt(1 - 2 * std::min(largest, tenfold)) - 1;
}

}  // namespace

std::vector<double> laminaStretch(const Wall& wall) {
  std::vector<double> stretch(wall.agents.size(), 0.0);
  for (Index i = 0; i < wall.agents.size(); ++i)
    if (wall.agents.kind[i] == AgentKind::iel) stretch[i] = largestPrincipalStrain(patchAbout(wall, i));
  return stretch;
}

}  // namespace restenosis

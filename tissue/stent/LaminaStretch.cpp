#include "tissue/stent/LaminaStretch.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace restenosis {
namespace {

using Vec2 = Eigen::Vector2d;
using Mat3 = Eigen::Matrix3d;

struct PatchBond {
  Vec3 vector;
  double restLength;
};

/// The bonds of the agent and of those it is bonded with, within the sheet.
std::vector<PatchBond> patchAbout(const Wall& wall, Index centre) {
  const AgentStore& agents = wall.agents;
  std::vector<PatchBond> patch;
  const auto addBondsOf = [&](Index i) {
    for (const Bond& bond : wall.bonds.of(i)) {
      if (agents.kind[bond.partner] != AgentKind::iel) continue;
      patch.push_back({agents.position(bond.partner) - agents.position(i), bond.restLength});
    }
  };
  addBondsOf(centre);
  for (const Bond& bond : wall.bonds.of(centre))
    if (agents.kind[bond.partner] == AgentKind::iel) addBondsOf(bond.partner);
  return patch;
}

/// Solution of least norm of the normal equations A x = b, A symmetric: it has no component along directions
/// that the bonds, too few or too much alike, do not determine.
Vec3 leastSquares(const Mat3& a, const Vec3& b) {
  constexpr double negligible = 1e-9;  // of the largest eigenvalue
  const Eigen::SelfAdjointEigenSolver<Mat3> eigen(a);
  Vec3 x = Vec3::Zero();
  for (int k = 0; k < 3; ++k) {
    const double value = eigen.eigenvalues()[k];
    if (value <= negligible * eigen.eigenvalues()[2]) continue;
    const Vec3 direction = eigen.eigenvectors().col(k);
    x += direction * (direction.dot(b) / value);
  }
  return x;
}

double largestPrincipalStrain(const std::vector<PatchBond>& patch) {
  if (patch.empty()) return 0;
  Mat3 inertia = Mat3::Zero();
  for (const PatchBond& bond : patch) inertia += bond.vector * bond.vector.transpose();
  // Eigenvalues are in rising order: the last two directions span the plane of the bonds.
  const Mat3 axes = Eigen::SelfAdjointEigenSolver<Mat3>(inertia).eigenvectors();
  Mat3 normal = Mat3::Zero();
  Vec3 right = Vec3::Zero();
  for (const PatchBond& bond : patch) {
    const Vec2 u = Vec2(axes.col(1).dot(bond.vector), axes.col(2).dot(bond.vector)).normalized();
    const Vec3 coefficients(2 * u[0] * u[0], 4 * u[0] * u[1], 2 * u[1] * u[1]);
    const double ratio = bond.restLength / bond.vector.norm();
    normal += coefficients * coefficients.transpose();
    right += coefficients * (1 - ratio * ratio);
  }
  const Vec3 e = leastSquares(normal, right);
  const double largest = 0.5 * (e[0] + e[2]) + std::hypot(0.5 * (e[0] - e[2]), e[1]);
  constexpr double tenfold = 0.5 * (1 - 0.01);  // elongation, the largest for which the fit is trusted
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

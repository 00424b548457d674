#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "tests/support/Constants.h"
#include "tissue/agents/RandomStream.h"
#include "tissue/stent/LaminaStretch.h"

namespace restenosis {
namespace {

using namespace support;

constexpr int cellsAcross = 7;

/// A flat, irregular sheet of IEL agents in the plane x = 1 mm, bonded at rest, with what `deform` makes of
/// each position.
template <class Deform>
Wall sheet(Deform deform) {
  Wall wall;
  for (int k = 0; k < cellsAcross * cellsAcross; ++k) {
    RandomStream stream(1, k, 0, RandomPurpose::packing);
    const double y = 2 * r * (k % cellsAcross) + 0.4 * r * stream.uniform();
    const double z = 2 * r * (k / cellsAcross + 0.5 * (k % 2)) + 0.4 * r * stream.uniform();
    wall.agents.append(AgentKind::iel, {1e-3, y, z}, r);
  }
  wall.bonds.resize(wall.agents.size());
  const auto distance = [&](Index a, Index b) {
    return (wall.agents.position(a) - wall.agents.position(b)).norm();
  };
  for (Index a = 0; a < wall.agents.size(); ++a)
    for (Index b = a + 1; b < wall.agents.size(); ++b)
      if (distance(a, b) < 3 * r) wall.bonds.connect(a, b, distance(a, b));
  for (Index a = 0; a < wall.agents.size(); ++a) wall.agents.setPosition(a, deform(wall.agents.position(a)));
  return wall;
}

/// At every agent with bonds enough to tell; those at the sheet's corners have one or two.
void expectEverywhere(const Wall& wall, double strain) {
  const std::vector<double> stretch = laminaStretch(wall);
  int told = 0;
  for (Index i = 0; i < wall.agents.size(); ++i) {
    if (wall.bonds.of(i).size() < 3) continue;
    EXPECT_NEAR(stretch[i], strain, 1e-5);
    ++told;
  }
  EXPECT_GT(told, cellsAcross * cellsAcross / 2);
}

TEST(LaminaStretch, IsExactForEvenDeformation) {
  expectEverywhere(sheet([](const Vec3& p) { return p; }), 0);
  expectEverywhere(sheet([](const Vec3& p) { return Vec3(p.x(), 1.2 * p.y(), p.z()); }), 0.2);
  expectEverywhere(sheet([](const Vec3& p) { return Vec3(p.x(), 1.2 * p.y(), 0.8 * p.z()); }), 0.2);
  expectEverywhere(sheet([](const Vec3& p) { return Vec3(p.x(), 0.9 * p.y(), 0.8 * p.z()); }), -0.1);
}

TEST(LaminaStretch, SeesShearAlongItsPrincipalDirection) {
  const double shear = 0.3;
  // The largest singular value of [1 shear; 0 1].
  const double stretch = std::sqrt(1 + shear * shear / 2 + shear * std::sqrt(1 + shear * shear / 4));
  expectEverywhere(sheet([&](const Vec3& p) { return Vec3(p.x(), p.y() + shear * p.z(), p.z()); }),
                   stretch - 1);
}

TEST(LaminaStretch, DoesNotChangeUnderRotation) {
  const Eigen::Matrix3d rotation = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  expectEverywhere(sheet([&](const Vec3& p) { return Vec3(rotation * Vec3(p.x(), 1.1 * p.y(), p.z())); }),
                   0.1);
}

TEST(LaminaStretch, HearsLessOfOneSlippedAgentThanItsBondsDo) {
  const Index slipped = cellsAcross * cellsAcross / 2;
  Wall wall = sheet([](const Vec3& p) { return p; });
  wall.agents.y[slipped] += 0.3 * r;
  double largestBondStrain = 0;
  for (const Bond& bond : wall.bonds.of(slipped)) {
    const double length = (wall.agents.position(slipped) - wall.agents.position(bond.partner)).norm();
    largestBondStrain = std::max(largestBondStrain, length / bond.restLength - 1);
  }
  EXPECT_LT(laminaStretch(wall)[slipped], 0.5 * largestBondStrain);
}

TEST(LaminaStretch, NeedsNoMoreThanOneBondAndIsZeroWithout) {
  Wall wall;
  for (const double z : {0.0, 2.2 * r, 10 * r}) wall.agents.append(AgentKind::iel, {1e-3, 0, z}, r);
  wall.agents.append(AgentKind::smc, {1e-3, 2 * r, 0}, r);
  wall.bonds.resize(4);
  wall.bonds.connect(0, 1, 2 * r);
  wall.bonds.connect(0, 3, r);
  const std::vector<double> stretch = laminaStretch(wall);
  EXPECT_NEAR(stretch[0], 0.1, 1e-6);
  EXPECT_NEAR(stretch[1], 0.1, 1e-6);
  EXPECT_EQ(stretch[2], 0.0);
  EXPECT_EQ(stretch[3], 0.0);
}

}  // namespace
}  // namespace restenosis

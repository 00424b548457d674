#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bridge/flow/lbm/WallFit.h"

namespace restenosis {
namespace {

/// Nodes of a cubic lattice below a plane through the origin with this normal, at some offset.
std::vector<NearNode> nodesBelow(const Vec3& normal, double reach) {
  std::vector<NearNode> nodes;
  std::uint32_t place = 0;
  for (int x = -4; x <= 4; ++x)
    for (int y = -4; y <= 4; ++y)
      for (int z = -4; z <= 4; ++z) {
        const Vec3 offset = Vec3(x, y, z) + Vec3(0.31, -0.17, 0.23);
        const double distance = offset.norm() / reach;
        if (distance < 1.0 && offset.dot(normal) < 0.0)
          nodes.push_back({place++, offset, 1.0 - distance * distance});
      }
  return nodes;
}

template <class Field>
double applied(const std::vector<NearNode>& nodes, const Field& field) {
  double sum = 0.0;
  for (const NearNode& n : nodes) sum += n.weight * field(n.offset);
  return sum;
}

const Vec3 oblique = Vec3(1.0, 2.0, -0.5).normalized();

TEST(WallFit, valueOfALinearFieldIsExact) {
  auto nodes = nodesBelow(oblique, 2.5);
  fitValue(nodes);
  EXPECT_NEAR(applied(nodes, [](const Vec3& p) { return 3.0 + p.x() - 2.0 * p.y() + 0.5 * p.z(); }), 3.0,
              1e-4);
}

TEST(WallFit, derivativeOfAQuadraticFieldThatVanishesOnTheWallIsExact) {
  auto nodes = nodesBelow(oblique, 3.0);
  fitWallDerivative(nodes, oblique);
  const Vec3 along = oblique.unitOrthogonal();
  const auto field = [&](const Vec3& p) {
    const double d = -p.dot(oblique), s = p.dot(along);
    return 2.0 * d - 0.3 * d * d + 0.2 * d * s;
  };
  EXPECT_NEAR(applied(nodes, field), 2.0, 1e-4);
}

TEST(WallFit, theWallMayBend) {
  auto nodes = nodesBelow(oblique, 3.0);
  fitWallDerivative(nodes, oblique);
  const Vec3 along = oblique.unitOrthogonal();
  // Zero on the wall d = s^2 / (2 R) with R = 15
  const auto field = [&](const Vec3& p) {
    const double d = -p.dot(oblique), s = p.dot(along);
    return d - s * s / 30.0;
  };
  EXPECT_NEAR(applied(nodes, field), 1.0, 1e-4);
}

/// Sets the distance from a bumpy wall, -p.n + h cos(k s) at the face.
double bumpyDistance(const Vec3& p) {
  return -p.dot(oblique) + 0.2 * (1.0 - std::cos(1.5 * p.dot(oblique.unitOrthogonal())));
}

TEST(WallFit, ratioToTheDistanceOfAnyWallIsFound) {
  auto nodes = nodesBelow(oblique, 2.25);
  for (NearNode& n : nodes) n.wallDistance = bumpyDistance(n.offset);
  fitWallRatio(nodes);
  EXPECT_NEAR(applied(nodes, [](const Vec3& p) { return 3.0 * bumpyDistance(p); }), 3.0, 1e-12);
}

TEST(WallFit, slopesOfTheRatioAreMostlyFollowed) {
  auto nodes = nodesBelow(oblique, 2.25);
  for (NearNode& n : nodes) n.wallDistance = -n.offset.dot(oblique);
  fitWallRatio(nodes);
  // Poiseuille's flow in a tube of 30 spacings, near its wall; the mean ratio would be off by 3 %
  const auto field = [](const Vec3& p) { return -p.dot(oblique) * (1.0 + p.dot(oblique) / 30.0); };
  EXPECT_NEAR(applied(nodes, field), 1.0, 0.01);
}

TEST(WallFit, nodesBeyondAnEdgeDoNotFaceThePlane) {
  // A plane that ends at s = 0: beyond, the edge is the nearest place of the wall
  const Vec3 along = oblique.unitOrthogonal();
  auto nodes = nodesBelow(oblique, 3.0);
  for (NearNode& n : nodes) {
    const double d = -n.offset.dot(oblique), s = std::max(0.0, n.offset.dot(along));
    n.wallDistance = std::hypot(d, s);
  }
  const std::size_t before = nodes.size();
  keepFacing(nodes, oblique);
  EXPECT_LT(nodes.size(), before);
  for (const NearNode& n : nodes) EXPECT_LT(n.offset.dot(along), 1.6);
  EXPECT_TRUE(std::ranges::any_of(nodes, [&](const NearNode& n) { return n.offset.dot(along) < -1.0; }));
}

TEST(WallFit, wherePlaneAndWallAreOneEveryNodeFaces) {
  auto nodes = nodesBelow(oblique, 3.0);
  for (NearNode& n : nodes) n.wallDistance = -n.offset.dot(oblique);
  const std::size_t before = nodes.size();
  keepFacing(nodes, oblique);
  EXPECT_EQ(nodes.size(), before);
}

TEST(WallFit, whereHardlyANodeFacesThePlaneAllStay) {
  std::vector<NearNode> nodes = {{0, -0.5 * oblique, 1.0, 3.0}, {1, -1.5 * oblique, 0.5, 3.0}};
  keepFacing(nodes, oblique);
  EXPECT_EQ(nodes.size(), 2);
}

TEST(WallFit, fewNodesGiveTheMeanRatio) {
  std::vector<NearNode> nodes = {{0, -0.5 * oblique, 1.0, 0.3}, {1, -1.5 * oblique, 0.5, 1.2}};
  fitWallRatio(nodes);
  EXPECT_NEAR(applied(nodes, [](const Vec3& p) { return p.norm() < 1.0 ? 2.0 * 0.3 : 2.0 * 1.2; }), 2.0,
              1e-12);
  nodes = {{0, Vec3::Zero(), 1.0, 0.0}};
  fitWallRatio(nodes);
  EXPECT_EQ(nodes.front().weight, 0.0);
}

TEST(WallFit, fewNodesGiveTheSlopeFromTheWall) {
  std::vector<NearNode> nodes = {{0, -0.5 * oblique, 1.0}, {1, -1.5 * oblique, 0.5}};
  fitWallDerivative(nodes, oblique);
  EXPECT_NEAR(applied(nodes, [](const Vec3& p) { return -3.0 * p.dot(oblique); }), 3.0, 1e-12);
}

TEST(WallFit, fewNodesGiveTheirMean) {
  std::vector<NearNode> nodes = {{0, -0.5 * oblique, 1.0}, {1, -1.5 * oblique, 3.0}};
  fitValue(nodes);
  EXPECT_NEAR(nodes[0].weight, 0.25, 1e-15);
  EXPECT_NEAR(nodes[1].weight, 0.75, 1e-15);
}

TEST(WallFit, nearest) {
  auto nodes = nodesBelow(oblique, 2.5);
  double least = 1e9;
  for (const auto& n : nodes) least = std::min(least, n.offset.norm());
  keepNearest(nodes);
  ASSERT_EQ(nodes.size(), 1u);
  EXPECT_EQ(nodes[0].weight, 1.0);
  EXPECT_EQ(nodes[0].offset.norm(), least);
}

}  // namespace
}  // namespace restenosis

#include "bridge/flow/lbm/WallFit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <functional>

namespace restenosis {
namespace {

/// Nodes below which no slope, and no curvature, is fitted.
constexpr std::size_t fewestForValue = 6, fewestForSlope = 8, fewestForCurvature = 12;
/// Ridge on the slopes, relative to the sum of weights: decides where nodes lie in a plane.
constexpr double ridge = 1e-6;
/// Most by which the fit may enlarge errors of the nodes: the sum of |weight| d, which is 1 for the fit of d
/// alone.
constexpr double mostAmplification = 4.0;
/// The same for the fit of the ratio to the wall distance: the sum of |weight| times that distance.
constexpr double mostRatioAmplification = 2.5;
/// Ridge on the slopes of that ratio (assumed; docs/results/flow.md).
constexpr double ratioRidge = 0.1;
/// Added to distances from the wall [spacings], so that a node on it does not count infinitely (assumed).
constexpr double distanceOfNodeOnWall = 0.1;

/// Nodes face a plane whose distance from it is that from the wall, but for this part of it and as many
/// spacings: planes of a drawing bend a little (assumed).
constexpr double facingPart = 0.1, facingSpacings = 0.05;
constexpr std::ptrdiff_t fewestFacing = 4;

constexpr int terms = 7;
using Row = Eigen::Matrix<double, terms, 1>;

/// The derivative of the fit of d alone.
void fitProportional(std::vector<NearNode>& nodes, const Vec3& n) {
  double sum = 0.0;
  for (const NearNode& node : nodes) sum += node.weight * node.offset.dot(n) * node.offset.dot(n);
  for (NearNode& node : nodes) node.weight *= sum > 0.0 ? -node.offset.dot(n) / sum : 0.0;
}

}  // namespace

void keepFacing(std::vector<NearNode>& nodes, const Vec3& outwardNormal) {
  const auto facing = [&](const NearNode& node) {
    return node.wallDistance <= -(1.0 + facingPart) * node.offset.dot(outwardNormal) + facingSpacings;
  };
  if (std::count_if(nodes.begin(), nodes.end(), facing) >= fewestFacing)
    std::erase_if(nodes, std::not_fn(facing));
}

void fitValue(std::vector<NearNode>& nodes) {
  Eigen::Matrix4d normalMatrix = Eigen::Matrix4d::Zero();
  double total = 0.0;
  const auto row = [](const NearNode& n) {
    return Eigen::Vector4d(1.0, n.offset.x(), n.offset.y(), n.offset.z());
  };
  for (const NearNode& n : nodes) {
    normalMatrix += n.weight * row(n) * row(n).transpose();
    total += n.weight;
  }
  if (nodes.size() < fewestForValue) {
    for (NearNode& n : nodes) n.weight /= total;
    return;
  }
  normalMatrix.diagonal().tail<3>().array() += ridge * total;
  const Eigen::Vector4d value = normalMatrix.ldlt().solve(Eigen::Vector4d::Unit(0));
  for (NearNode& n : nodes) n.weight *= value.dot(row(n));
}

void fitWallRatio(std::vector<NearNode>& nodes) {
  Eigen::Matrix4d normalMatrix = Eigen::Matrix4d::Zero();
  const auto row = [](const NearNode& n) {
    return Eigen::Vector4d(n.wallDistance * Eigen::Vector4d(1.0, n.offset.x(), n.offset.y(), n.offset.z()));
  };
  for (NearNode& n : nodes) {
    n.weight /= (n.wallDistance + distanceOfNodeOnWall) * (n.wallDistance + distanceOfNodeOnWall);
    normalMatrix += n.weight * row(n) * row(n).transpose();
  }
  const double total = normalMatrix(0, 0);
  if (!(total > 0.0)) {
    for (NearNode& n : nodes) n.weight = 0.0;
    return;
  }
  Eigen::Vector4d derivative = Eigen::Vector4d(1.0 / total, 0.0, 0.0, 0.0);
  if (nodes.size() >= fewestForSlope) {
    normalMatrix.diagonal().tail<3>().array() += ratioRidge * total;
    const Eigen::Vector4d linear = normalMatrix.ldlt().solve(Eigen::Vector4d::Unit(0));
    double amplification = 0.0;
    for (const NearNode& n : nodes) amplification += std::abs(n.weight * linear.dot(row(n)) * n.wallDistance);
    if (amplification < mostRatioAmplification) derivative = linear;
  }
  for (NearNode& n : nodes) n.weight *= derivative.dot(row(n));
}

void keepNearest(std::vector<NearNode>& nodes) {
  const auto nearest = std::min_element(nodes.begin(), nodes.end(), [](const NearNode& a, const NearNode& b) {
    return a.offset.squaredNorm() < b.offset.squaredNorm();
  });
  nodes = {{nearest->place, nearest->offset, 1.0}};
}

void fitWallDerivative(std::vector<NearNode>& nodes, const Vec3& outwardNormal) {
  const Vec3 along = outwardNormal.unitOrthogonal(), across = outwardNormal.cross(along);
  const auto row = [&](const NearNode& node) {
    const double d = -node.offset.dot(outwardNormal), s = node.offset.dot(along), t = node.offset.dot(across);
    Row r;
    r << d, d * d, d * s, d * t, s * s, s * t, t * t;
    return r;
  };
  Eigen::Matrix<double, terms, terms> normalMatrix = Eigen::Matrix<double, terms, terms>::Zero();
  double total = 0.0;
  for (const NearNode& node : nodes) {
    normalMatrix += node.weight * row(node) * row(node).transpose();
    total += node.weight;
  }
  normalMatrix.diagonal().tail<terms - 1>().array() += ridge * total;
  const Row derivative = normalMatrix.ldlt().solve(Row::Unit(0));
  double amplification = 0.0;
  for (const NearNode& node : nodes)
    amplification += std::abs(node.weight * derivative.dot(row(node)) * node.offset.dot(outwardNormal));
  if (nodes.size() < fewestForCurvature || !(amplification < mostAmplification)) {
    fitProportional(nodes, outwardNormal);
    return;
  }
  for (NearNode& node : nodes) node.weight *= derivative.dot(row(node));
}

}  // namespace restenosis

#include "bridge/flow/lbm/DevelopedProfile.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace restenosis {
namespace {

/// Most sweeps and largest relative change at the end of the solution for the velocity.
constexpr int mostSweeps = 20000;
constexpr double sweepTolerance = 1e-7;
/// A node on the wall would make its own velocity's equation singular.
constexpr double shortestArm = 1e-3;
/// Of the directions along x and y, in the order of a node's arms.
constexpr int firstAxis = 1;
/// Turns in which velocity and viscosity are found, at most, and the relative change of viscosity that ends
/// them: a power law of index n comes nearer by the factor 1 - n a turn.
constexpr int mostTurns = 60;
constexpr double turnTolerance = 1e-4;

}  // namespace

DevelopedProfile::DevelopedProfile(const LumenLattice& layer)
    : shape_(layer.layout.places(), 0.0), relative_(layer.layout.places(), 1.0) {
  for (const NodeRun& run : layer.layout.runs()) {
    Node node{run.first, {}};
    for (std::size_t a = 0; a < 4; ++a) {
      const d3q19::Step& c = d3q19::c[a + firstAxis];
      node.arms[a].place = layer.layout.place(run.x + c[0], run.y + c[1], 0);
    }
    nodes_.push_back(node);
  }
  for (const SurfaceLink& link : layer.links) {
    if (link.direction < firstAxis || link.direction >= firstAxis + 4) continue;
    const auto node = std::lower_bound(nodes_.begin(), nodes_.end(), link.node,
                                       [](const Node& n, std::uint32_t place) { return n.place < place; });
    Arm& arm = node->arms[static_cast<std::size_t>(link.direction - firstAxis)];
    arm.wall = true;
    arm.length = std::max(link.q, shortestArm);
  }
}

void DevelopedProfile::sweep() {
  std::vector<double>& u = shape_;
  const double across = std::sqrt(static_cast<double>(nodes_.size()));
  const double relaxation = 2.0 / (1.0 + std::sin(std::numbers::pi / (across + 1.0)));
  for (int n = 0; n < mostSweeps; ++n) {
    double change = 0.0, largest = 0.0;
    for (const Node& node : nodes_) {
      const double here = relative_[node.place];
      const auto between = [&](const Arm& arm) {
        return arm.wall ? here : 0.5 * (here + relative_[arm.place]);
      };
      double diagonal = 0.0, sum = 1.0;
      for (std::size_t axis = 0; axis < 2; ++axis) {
        const Arm &plus = node.arms[2 * axis], &minus = node.arms[2 * axis + 1];
        const double half = 0.5 * (plus.length + minus.length);
        diagonal += between(plus) / (plus.length * half) + between(minus) / (minus.length * half);
        if (!plus.wall) sum += between(plus) * u[plus.place] / (plus.length * half);
        if (!minus.wall) sum += between(minus) * u[minus.place] / (minus.length * half);
      }
      const double step = relaxation * (sum / diagonal - u[node.place]);
      u[node.place] += step;
      change = std::max(change, std::abs(step));
      largest = std::max(largest, std::abs(u[node.place]));
    }
    if (change <= sweepTolerance * largest) break;
  }
}

void DevelopedProfile::solve(double flowRate, double relaxationTime) {
  sweep();
  double shapeFlow = 0.0;
  for (const double u : shape_) shapeFlow += u;
  if (!(shapeFlow > 0.0))
    throw std::invalid_argument("no lattice node lies behind the inlet: choose a smaller dx in [lbm]");
  velocity_ = shape_;
  for (double& u : velocity_) u = flowRate / shapeFlow * u;
  viscosity_ = relative_;
  for (double& nu : viscosity_) nu *= (relaxationTime - 0.5) / 3.0;
  force_ = flowRate / shapeFlow * (relaxationTime - 0.5) / 3.0;
}

void DevelopedProfile::solve(double flowRate, const ViscosityLaw& law, double relaxationTime) {
  const double first = (relaxationTime - 0.5) / 3.0;
  for (int turn = 0; turn < mostTurns; ++turn) {
    solve(flowRate, relaxationTime);
    double change = 0.0;
    std::vector<double> next = relative_;
    for (const Node& node : nodes_) {
      next[node.place] = law(shearRate(node)) / first;
      change = std::max(change, std::abs(next[node.place] / relative_[node.place] - 1.0));
    }
    relative_ = std::move(next);
    if (change < turnTolerance) break;
  }
  solve(flowRate, relaxationTime);
}

double DevelopedProfile::shearRate(const Node& node) const {
  const double u = velocity_[node.place];
  double square = 0.0;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const Arm &plus = node.arms[2 * axis], &minus = node.arms[2 * axis + 1];
    const double ahead = ((plus.wall ? 0.0 : velocity_[plus.place]) - u) / plus.length;
    const double behind = (u - (minus.wall ? 0.0 : velocity_[minus.place])) / minus.length;
    const double slope = (ahead * minus.length + behind * plus.length) / (plus.length + minus.length);
    square += slope * slope;
  }
  return std::sqrt(square);
}

}  // namespace restenosis

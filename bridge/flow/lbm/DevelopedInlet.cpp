#include "bridge/flow/lbm/DevelopedInlet.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "bridge/flow/lbm/InletLayer.h"

namespace restenosis {
namespace {

using d3q19::Step;

/// Steps in which the populations of the layer adapt to a velocity that is already right.
constexpr int settlingPairs = 250;
/// Most sweeps and largest relative change at the end of the solution for the velocity.
constexpr int mostSweeps = 20000;
constexpr double sweepTolerance = 1e-7;
/// A node on the wall would make its own velocity's equation singular.
constexpr double shortestArm = 1e-3;

/// What the links of the layer cross, as regions of three triangles.
const std::vector<SurfaceRegion> layerRegions{SurfaceRegion::wall, SurfaceRegion::inlet,
                                              SurfaceRegion::outlet};

int directionOf(int x, int y, int z) {
  const auto found = std::find(d3q19::c.begin(), d3q19::c.end(), Step{x, y, z});
  return static_cast<int>(found - d3q19::c.begin());
}

}  // namespace

DevelopedInlet::DevelopedInlet(const LumenLattice& lattice, const std::vector<SurfaceRegion>& region,
                               WallRule rule, const LatticeRelaxation& relaxation, double flowRate)
    : layer_(layer(lattice, region)) {
  const auto shape = profile(layer_);
  double shapeFlow = 0.0;
  for (const double u : shape) shapeFlow += u;
  if (!(shapeFlow > 0.0))
    throw std::invalid_argument("no lattice node lies behind the inlet: choose a smaller dx in [lbm]");

  LatticeEnds ends;
  ends.inlet = LatticeEnds::Inlet::periodic;
  LatticeRelaxation driven = relaxation;
  driven.force = Vec3(0.0, 0.0, flowRate / shapeFlow * (relaxation.tau - 0.5) / 3.0);
  LatticeFlow<double> flow(layer_.layout, makeBoundary(layer_, layerRegions, rule, ends), driven);
  flow.initialise([&](std::uint32_t place) {
    NodeState s;
    s.velocity.z() = flowRate / shapeFlow * shape[place];
    return s;
  });
  flow.advance(settlingPairs);

  // What comes in against what leaves; the latter has arrived one layer further on, which is the same layer
  const ColumnLayout& layout = layer_.layout;
  sources_.assign(static_cast<std::size_t>(d3q19::directions) * layout.places(), 0.0);
  double total = 0.0;
  for (const SurfaceLink& link : layer_.links) {
    if (layerRegions[link.triangle] != SurfaceRegion::inlet) continue;
    const Step& c = d3q19::c[link.direction];
    const std::uint32_t next = layout.place(link.coordinates[0] + c[0], link.coordinates[1] + c[1], 0);
    const double source =
        flow.population(link.node, d3q19::opposite(link.direction)) - flow.population(next, link.direction);
    sources_[static_cast<std::size_t>(link.direction) * layout.places() + link.node] = source;
    total += source;
  }
  if (!(total > 0.0) || !std::isfinite(total))
    throw std::invalid_argument(
        "developed flow through the inlet was not found: choose a smaller dx in [lbm]");
  for (double& s : sources_) s *= flowRate / total;
}

double DevelopedInlet::source(const Step& node, int direction) const {
  return sources_[static_cast<std::size_t>(direction) * layer_.layout.places() +
                  layer_.layout.place(node[0], node[1], 0)];
}

LumenLattice DevelopedInlet::layer(const LumenLattice& lattice,
                                   const std::vector<SurfaceRegion>& region) const {
  const InletLayer behind(lattice, region);
  const auto isFluid = [&](int x, int y) { return behind.contains(x, y); };
  LatticeFrame frame = lattice.frame;
  frame.size[2] = 1;
  frame.inletLayer = 0;
  frame.alongZ = true;
  ColumnLayout layout(frame.size, [&](int x, int y, int) { return isFluid(x, y); });

  std::vector<SurfaceLink> links;
  const auto add = [&](const Step& node, int direction, double q, bool interpolable, std::uint32_t triangle) {
    links.push_back(
        {layout.place(node), static_cast<std::uint8_t>(direction), false, interpolable, q, triangle, node});
  };
  for (const SurfaceLink& link : lattice.links) {
    const Step& c = d3q19::c[link.direction];
    const SurfaceRegion crossed = region[link.triangle];
    if (!behind.contains(link.coordinates) || c[2] != 0 || crossed == SurfaceRegion::inlet ||
        crossed == SurfaceRegion::outlet)
      continue;
    const Step node{link.coordinates[0], link.coordinates[1], 0};
    add(node, link.direction, link.q, link.interpolable, 0);
    if (c[0] * c[1] != 0) continue;  // D3Q19 has no links along the diagonals of space
    for (const int z : {-1, 1}) add(node, directionOf(c[0], c[1], z), link.q, link.interpolable, 0);
  }
  for (const NodeRun& run : layout.runs())
    for (int direction = 1; direction < d3q19::directions; ++direction) {
      const Step& c = d3q19::c[static_cast<std::size_t>(direction)];
      if (c[2] == 0 || !isFluid(run.x + c[0], run.y + c[1])) continue;
      add({run.x, run.y, 0}, direction, 0.5, false, c[2] < 0 ? 1 : 2);
    }
  std::sort(links.begin(), links.end(), [](const SurfaceLink& a, const SurfaceLink& b) {
    return std::pair(a.direction, a.node) < std::pair(b.direction, b.node);
  });
  return {frame, std::move(layout), std::move(links)};
}

std::vector<double> DevelopedInlet::profile(const LumenLattice& layer) {
  // Laplace's operator with the distances to the wall (Shortley and Weller) equals -1; successive
  // over-relaxation
  struct Arm {
    double length = 1.0;
    bool wall = false;
    std::uint32_t place = 0;
  };
  struct Node {
    std::uint32_t place;
    std::array<Arm, 4> arms;  // +x, -x, +y, -y
  };
  constexpr int firstAxis = 1;  // of the directions along x and y, in this order
  std::vector<Node> nodes;
  for (const NodeRun& run : layer.layout.runs()) {
    Node node{run.first, {}};
    for (std::size_t a = 0; a < 4; ++a) {
      const Step& c = d3q19::c[a + firstAxis];
      node.arms[a].place = layer.layout.place(run.x + c[0], run.y + c[1], 0);
    }
    nodes.push_back(node);
  }
  for (const SurfaceLink& link : layer.links) {
    if (link.direction < firstAxis || link.direction >= firstAxis + 4) continue;
    const auto node = std::lower_bound(nodes.begin(), nodes.end(), link.node,
                                       [](const Node& n, std::uint32_t place) { return n.place < place; });
    Arm& arm = node->arms[static_cast<std::size_t>(link.direction - firstAxis)];
    arm.wall = true;
    arm.length = std::max(link.q, shortestArm);
  }
  std::vector<double> u(layer.layout.places(), 0.0);
  const double across = std::sqrt(static_cast<double>(nodes.size()));
  const double relaxation = 2.0 / (1.0 + std::sin(std::numbers::pi / (across + 1.0)));
  for (int sweep = 0; sweep < mostSweeps; ++sweep) {
    double change = 0.0, largest = 0.0;
    for (const Node& node : nodes) {
      double diagonal = 0.0, sum = 1.0;
      for (std::size_t axis = 0; axis < 2; ++axis) {
        const Arm &plus = node.arms[2 * axis], &minus = node.arms[2 * axis + 1];
        const double half = 0.5 * (plus.length + minus.length);
        diagonal += 1.0 / (plus.length * half) + 1.0 / (minus.length * half);
        if (!plus.wall) sum += u[plus.place] / (plus.length * half);
        if (!minus.wall) sum += u[minus.place] / (minus.length * half);
      }
      const double step = relaxation * (sum / diagonal - u[node.place]);
      u[node.place] += step;
      change = std::max(change, std::abs(step));
      largest = std::max(largest, std::abs(u[node.place]));
    }
    if (change <= sweepTolerance * largest) break;
  }
  return u;
}

}  // namespace restenosis

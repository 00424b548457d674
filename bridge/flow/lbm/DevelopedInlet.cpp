#include "bridge/flow/lbm/DevelopedInlet.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "bridge/flow/lbm/DevelopedProfile.h"
#include "bridge/flow/lbm/InletLayer.h"

namespace restenosis {
namespace {

using d3q19::Step;

/// Pairs of steps in which the populations of the layer adapt to a velocity that is already right: more
/// change what comes in by a ten-thousandth of the largest.
constexpr int settlingPairs = 60;

/// What the links of the layer cross, as regions of three triangles.
const std::vector<SurfaceRegion> layerRegions{SurfaceRegion::wall, SurfaceRegion::inlet,
                                              SurfaceRegion::outlet};

int directionOf(int x, int y, int z) {
  const auto found = std::find(d3q19::c.begin(), d3q19::c.end(), Step{x, y, z});
  return static_cast<int>(found - d3q19::c.begin());
}

}  // namespace

DevelopedInlet::DevelopedInlet(const LumenLattice& lattice, const std::vector<SurfaceRegion>& region,
                               WallRule rule, const LatticeRelaxation& relaxation, double flowRate,
                               const std::optional<ViscosityLaw>& thinning)
    : layer_(layer(lattice, region)) {
  DevelopedProfile developed(layer_);
  if (thinning)
    developed.solve(flowRate, *thinning, relaxation.tau);
  else
    developed.solve(flowRate, relaxation.tau);

  LatticeEnds ends;
  ends.inlet = LatticeEnds::Inlet::periodic;
  LatticeRelaxation driven = relaxation;
  driven.force = Vec3(0.0, 0.0, developed.force());
  LatticeFlow<double> flow(layer_.layout, makeBoundary(layer_, layerRegions, rule, ends), driven);
  if (thinning) flow.setViscosity([&](std::uint32_t place) { return developed.viscosity(place); });
  flow.initialise([&](std::uint32_t place) {
    NodeState s;
    s.velocity.z() = developed.velocity(place);
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

}  // namespace restenosis

#include "bridge/flow/lbm/LumenLattice.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <tuple>

#include "bridge/flow/LumenShape.h"
#include "bridge/flow/lbm/LatticeInterior.h"

namespace restenosis {
namespace {

LatticeFrame frameOf(const TriSurface& lumen, double spacing, double mostNodes) {
  const LumenEnd inlet = lumenEnd(lumen, SurfaceRegion::inlet);
  Vec3 low = lumen.vertices[lumen.triangles.front()[0]], high = low;
  for (const auto& t : lumen.triangles)
    for (const auto v : t) {
      low = low.cwiseMin(lumen.vertices[v]);
      high = high.cwiseMax(lumen.vertices[v]);
    }
  const double estimate = (high - low).prod() / (spacing * spacing * spacing);
  if (!(estimate < mostNodes))
    throw std::invalid_argument(fmt::format(
        "the box around the lumen ({:.4g} x {:.4g} x {:.4g} mm) has {:.2g} lattice nodes at a spacing of "
        "{:.4g} um, more than {:.2g}: choose a larger dx in [lbm], or check the lumen's length unit",
        1e3 * (high - low).x(), 1e3 * (high - low).y(), 1e3 * (high - low).z(), estimate, 1e6 * spacing,
        mostNodes));
  LatticeFrame frame;
  frame.alongZ = liesAlongZ(lumen);
  double dx = spacing, layers = 0.0;
  if (frame.alongZ) {
    const double length = lumenEnd(lumen, SurfaceRegion::outlet).z - inlet.z;
    layers = std::max(1.0, std::round(length / spacing));
    dx = length / layers;
  } else {
    frame.inletLayer = static_cast<int>(std::ceil((inlet.z - low.z()) / dx + 0.5));
    layers = frame.inletLayer + std::ceil((high.z() - inlet.z) / dx + 0.5);
  }
  // A node on the inlet's centre line
  const auto before = [&](double centre, double lowest) { return std::ceil((centre - lowest) / dx); };
  const double x = before(inlet.centre.x(), low.x()), y = before(inlet.centre.y(), low.y());
  frame.dx = dx;
  frame.origin =
      Vec3(inlet.centre.x() - x * dx, inlet.centre.y() - y * dx, inlet.z + (0.5 - frame.inletLayer) * dx);
  frame.size = {static_cast<int>(x + before(high.x(), inlet.centre.x())) + 1,
                static_cast<int>(y + before(high.y(), inlet.centre.y())) + 1, static_cast<int>(layers)};
  return frame;
}

/// A shift of the lattice [spacings] far below any effect, by which nodes that lie exactly on the surface
/// leave it.
Vec3 nudge(int attempt) { return 1e-6 * (1 + attempt) * Vec3(0.3719, 0.6131, 0.2357); }

std::vector<SurfaceLink> linksOf(const LatticeInterior& interior, const ColumnLayout& layout) {
  std::vector<SurfaceLink> links;
  const auto add = [&](const d3q19::Step& node, int direction, double q, std::uint32_t triangle) {
    if (!interior.fluid(node)) return;
    const auto& c = d3q19::c[static_cast<std::size_t>(direction)];
    const d3q19::Step beyond{node[0] + c[0], node[1] + c[1], node[2] + c[2]};
    const d3q19::Step behind{node[0] - c[0], node[1] - c[1], node[2] - c[2]};
    const bool interpolable = interior.fluid(behind) && !interior.cut(node, d3q19::opposite(direction));
    links.push_back({layout.place(node), static_cast<std::uint8_t>(direction), interior.fluid(beyond),
                     interpolable, std::clamp(q, 0.0, 1.0), triangle, node});
  };
  interior.forEachCut([&](const LatticeInterior::Cut& cut) {
    add(cut.lower, cut.direction, cut.first, cut.firstTriangle);
    add(cut.upper, d3q19::opposite(cut.direction), 1.0 - cut.last, cut.lastTriangle);
  });
  std::sort(links.begin(), links.end(), [](const SurfaceLink& a, const SurfaceLink& b) {
    return std::tie(a.direction, a.node) < std::tie(b.direction, b.node);
  });
  return links;
}

}  // namespace

bool LumenLattice::isFluid(const d3q19::Step& node) const {
  // Runs are sorted by x, y, z
  const auto after = std::ranges::upper_bound(layout.runs(), node, {}, [](const NodeRun& run) {
    return d3q19::Step{run.x, run.y, run.z};
  });
  if (after == layout.runs().begin()) return false;
  const NodeRun& run = *(after - 1);
  return run.x == node[0] && run.y == node[1] && node[2] < run.z + static_cast<int>(run.count);
}

void requireLatticeLumen(const TriSurface& lumen) {
  requireLumenWithPlanarEnds(lumen);
  if (liesAlongZ(lumen)) return;
  const EndPlane inlet = endPlane(lumen, SurfaceRegion::inlet);
  if (!(inlet.normal.z() < -1.0 + 1e-9))
    throw std::invalid_argument(
        "the inlet of the lumen surface must be a plane of constant z that the flow enters along z");
}

LumenLattice makeLumenLattice(const TriSurface& lumen, double spacing, double mostNodes) {
  requireLatticeLumen(lumen);
  if (!(spacing > 0.0) || !std::isfinite(spacing))
    throw std::invalid_argument(fmt::format("the spacing dx of the lattice is {}", spacing));
  const LatticeFrame frame = frameOf(lumen, spacing, mostNodes);
  std::optional<LatticeInterior> interior;
  constexpr int attempts = 8;
  for (int attempt = 0; attempt < attempts && !interior; ++attempt) {
    std::vector<Vec3> vertices(lumen.vertices);
    for (Vec3& v : vertices) v = (v - frame.origin) / frame.dx + nudge(attempt);
    LatticeInterior trial(vertices, lumen.triangles, frame.size);
    if (trial.consistent()) interior = std::move(trial);
  }
  if (!interior)
    throw std::invalid_argument(
        "lines of lattice nodes do not enter and leave the lumen surface in turn: it intersects itself");
  if (!interior->keepConnected(lumen.region))
    throw std::invalid_argument(fmt::format(
        "at a spacing of {:.4g} um no lattice nodes join inlet and outlet: the lumen is closed, or "
        "needs a smaller dx in [lbm]",
        1e6 * frame.dx));
  ColumnLayout layout(frame.size, [&](int x, int y, int z) { return interior->fluid({x, y, z}); });
  auto links = linksOf(*interior, layout);
  return {frame, std::move(layout), std::move(links)};
}

}  // namespace restenosis

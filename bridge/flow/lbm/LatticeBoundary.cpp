#include "bridge/flow/lbm/LatticeBoundary.h"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>

namespace restenosis {
namespace {

using d3q19::Step;

/// A node on the wall would make a gradient at it infinite [spacings].
constexpr double nearestWall = 0.1;

/// In the edge between a straight outlet and a wall along z a node has nine.
constexpr int leastNeighbours = 9;

class BoundaryMaker {
 public:
  BoundaryMaker(const LumenLattice& lattice, WallRule rule, const LatticeEnds& ends)
      : lattice_(lattice), layout_(lattice.layout), rule_(rule), ends_(ends) {
    for (const NodeRun& run : layout_.runs()) fluidAt_.insert(run.first, run.count);
  }

  LatticeBoundary make(const std::vector<SurfaceRegion>& region) {
    region_ = &region;
    for (const SurfaceLink& link : lattice_.links) {
      const SurfaceRegion end = region[link.triangle];
      const bool inlet = end == SurfaceRegion::inlet, outlet = end == SurfaceRegion::outlet;
      if (link.bothFluid)
        addThin(link);
      else if ((inlet || outlet) && ends_.inlet == LatticeEnds::Inlet::periodic)
        addPassage(link);
      else if (outlet && !lattice_.frame.alongZ)
        addOpen(link);
      else if (outlet || (inlet && ends_.inlet == LatticeEnds::Inlet::pressure))
        addPressure(link, outlet);
      else if (inlet && ends_.source && !entersInside(link))
        addWallBeyondEnd(link);
      else
        addWall(link, inlet);
    }
    return std::move(result_);
  }

 private:
  /// Which places hold fluid, by runs.
  struct FluidPlaces {
    void insert(std::uint32_t first, std::uint32_t count) { firstOfEnd.emplace(first + count, first); }
    bool contains(std::uint32_t place) const {
      const auto run = firstOfEnd.upper_bound(place);
      return run != firstOfEnd.end() && place >= run->second;
    }
    std::map<std::uint32_t, std::uint32_t> firstOfEnd;
  };

  std::uint32_t slot(std::uint32_t place, int direction) const {
    return static_cast<std::uint32_t>(direction) * layout_.places() + place;
  }
  std::uint32_t near(const SurfaceLink& l) const { return slot(l.node, d3q19::opposite(l.direction)); }
  std::uint32_t far(const SurfaceLink& l) const {
    return slot(layout_.place(d3q19::moved(l.coordinates, l.direction)), l.direction);
  }
  /// The node with z taken round from one end to the other.
  Step wrapped(Step n) const {
    const int layers = layout_.size()[2];
    n[2] = (n[2] + layers) % layers;
    return n;
  }

  const SurfaceLink* find(std::uint32_t node, int direction) const {
    const auto at = std::lower_bound(lattice_.links.begin(), lattice_.links.end(), std::pair(direction, node),
                                     [](const SurfaceLink& l, const std::pair<int, std::uint32_t>& wanted) {
                                       return std::pair(static_cast<int>(l.direction), l.node) < wanted;
                                     });
    const bool found = at != lattice_.links.end() && at->direction == direction && at->node == node;
    return found ? &*at : nullptr;
  }
  /// Whether a node and its neighbour are fluid and nothing lies between them.
  bool joined(const Step& node, int direction) const {
    const Step other = d3q19::moved(node, direction);
    const auto inRange = [&](const Step& n) { return n[2] >= 0 && n[2] < layout_.size()[2]; };
    return inRange(node) && inRange(other) && fluidAt_.contains(layout_.place(node)) &&
           fluidAt_.contains(layout_.place(other)) && find(layout_.place(node), direction) == nullptr;
  }

  void addWall(const SurfaceLink& link, bool inlet) {
    LatticeBoundary::WallLink wall{link.node, link.direction, 0, 0.0, 0.0};
    // Without a node behind (a gap one node wide) the wall is taken to be half a link away
    double q = 0.5;
    if (rule_ == WallRule::interpolated) {
      const int opposite = d3q19::opposite(link.direction);
      const Step behind = d3q19::moved(link.coordinates, opposite);
      // Through an open outlet arrives what OpenLinks puts there
      bool interpolable = link.interpolable || leadsThroughOpenOutlet(link.node, opposite);
      if (isBeyondEnd(link, behind[2])) {
        if (ends_.inlet == LatticeEnds::Inlet::periodic) {
          interpolable = fluidAt_.contains(layout_.place(wrapped(behind)));
        } else {
          // Beyond an end the flow goes on as before: what is one layer further in stands for it
          wall.inward = static_cast<std::int8_t>(d3q19::c[link.direction][2]);
          Step here = link.coordinates;
          here[2] += wall.inward;
          interpolable = joined(here, opposite);
        }
      }
      if (interpolable) {
        q = link.q;
        wall.k = (1.0 - 2.0 * q) / (1.0 + 2.0 * q);
      } else {
        wall.inward = 0;
      }
    }
    if (inlet) wall.source = inletSource(link, q);
    result_.wall.push_back(wall);
  }

  /// Whether the node behind a link, in this layer, lies beyond an end that is a layer.
  bool isBeyondEnd(const SurfaceLink& link, int layer) const {
    if (lattice_.frame.alongZ) return layer < 0 || layer >= layout_.size()[2];
    if (layer >= lattice_.frame.inletLayer || link.coordinates[2] != lattice_.frame.inletLayer) return false;
    const SurfaceLink* crossed = find(link.node, d3q19::opposite(link.direction));
    return crossed != nullptr && (*region_)[crossed->triangle] == SurfaceRegion::inlet;
  }

  bool leadsThroughOpenOutlet(std::uint32_t node, int direction) const {
    if (lattice_.frame.alongZ) return false;
    const SurfaceLink* crossed = find(node, direction);
    return crossed != nullptr && (*region_)[crossed->triangle] == SurfaceRegion::outlet;
  }

  double inletSource(const SurfaceLink& link, double q) const {
    if (ends_.source) return ends_.source(link.coordinates, link.direction);
    const Step& c = d3q19::c[link.direction];
    const Vec3 direction(c[0], c[1], c[2]);
    const Vec3 crossing = lattice_.frame.position(link.coordinates) + link.q * lattice_.frame.dx * direction;
    return -12.0 * d3q19::weight(link.direction) / (1.0 + 2.0 * q) * direction.dot(ends_.velocity(crossing));
  }

  /// Whether the link, gone back into the layer it comes from, ends at a fluid node.
  bool entersInside(const SurfaceLink& link) const {
    const Step& c = d3q19::c[link.direction];
    const Step& n = link.coordinates;
    return fluidAt_.contains(layout_.place(n[0] + c[0], n[1] + c[1], n[2]));
  }

  void addThin(const SurfaceLink& link) {
    if (link.direction % 2 == 1) result_.thin.push_back({near(link), far(link)});
  }

  void addPressure(const SurfaceLink& link, bool outlet) {
    const int inward = -d3q19::c[link.direction][2];
    Step inner = link.coordinates;
    inner[2] += inward;
    if (!fluidAt_.contains(layout_.place(inner))) {  // a spur of the lumen that ends here
      addWall(link, false);
      return;
    }
    auto& nodes = result_.pressureNodes;
    const auto [entry, isNew] = pressureNode_.try_emplace({link.node, outlet}, nodes.size());
    if (isNew)
      nodes.push_back(
          {link.node, static_cast<std::int8_t>(inward), outlet, 0, outlet ? 0.0 : ends_.inletDensity});
    nodes[entry->second].links |= std::uint32_t{1} << link.direction;
  }

  void addOpen(const SurfaceLink& link) {
    const Step& c = d3q19::c[link.direction];
    const double halfLinkOff = (0.5 - link.q) * ends_.outletGradient.dot(Vec3(c[0], c[1], c[2]));
    const SurfaceLink* behind = find(link.node, d3q19::opposite(link.direction));
    const double wallBehind = behind != nullptr ? std::max(behind->q, nearestWall) : 0.0;
    result_.open.push_back({link.coordinates, link.direction, wallBehind, isAlone(link.node), halfLinkOff});
  }

  bool isAlone(std::uint32_t node) const {
    int neighbours = 0;
    for (int i = 1; i < d3q19::directions; ++i) neighbours += find(node, i) == nullptr ? 1 : 0;
    return neighbours < leastNeighbours;
  }

  void addPassage(const SurfaceLink& link) {
    const int opposite = d3q19::opposite(link.direction);
    const Step target = wrapped(d3q19::moved(link.coordinates, link.direction));
    const std::uint32_t place = layout_.place(target);
    if (!fluidAt_.contains(place)) {
      addWallBeyondEnd(link);
      return;
    }
    result_.passages.push_back({near(link), slot(layout_.place(d3q19::moved(target, opposite)), opposite),
                                far(link), slot(place, link.direction)});
  }

  /// A link that leaves through an end and would meet the wall on the other side of it. Where the lumen goes
  /// on beyond its ends as it was before, the wall is as far as along the same link without its part in z.
  void addWallBeyondEnd(const SurfaceLink& link) {
    const Step& c = d3q19::c[link.direction];
    SurfaceLink across = link;
    across.direction = static_cast<std::uint8_t>(
        std::find(d3q19::c.begin(), d3q19::c.end(), Step{c[0], c[1], 0}) - d3q19::c.begin());
    const SurfaceLink* found = find(across.node, across.direction);
    if (found == nullptr)
      throw std::invalid_argument("a periodic flow needs equal ends: the lumen's inlet and outlet differ");
    SurfaceLink wall = link;
    wall.q = found->q;
    addWall(wall, false);
  }

  const LumenLattice& lattice_;
  const ColumnLayout& layout_;
  WallRule rule_;
  const LatticeEnds& ends_;
  const std::vector<SurfaceRegion>* region_ = nullptr;
  FluidPlaces fluidAt_;
  std::map<std::pair<std::uint32_t, bool>, std::size_t> pressureNode_;
  LatticeBoundary result_;
};

}  // namespace

LatticeBoundary makeBoundary(const LumenLattice& lattice, const std::vector<SurfaceRegion>& region,
                             WallRule rule, const LatticeEnds& ends) {
  return BoundaryMaker(lattice, rule, ends).make(region);
}

}  // namespace restenosis

#include "LatticeBoundary.h"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <tuple>
#include <unordered_map>

namespace restenosis {
namespace {

using d3q19::Step;

Step moved(const Step& n, int direction) {
  const Step& c = d3q19::c[static_cast<std::size_t>(direction)];
  return {n[0] + c[0], n[1] + c[1], n[2] + c[2]};
}

class BoundaryMaker {
 public:
  BoundaryMaker(const LumenLattice& lattice, WallRule rule, const LatticeEnds& ends)
      : lattice_(lattice), layout_(lattice.layout), rule_(rule), ends_(ends) {
    for (const NodeRun& run : layout_.runs()) fluidAt_.insert(run.first, run.count);
  }

  LatticeBoundary make(const std::vector<SurfaceRegion>& region) {
    for (const SurfaceLink& link : lattice_.links) {
      const SurfaceRegion end = region[link.triangle];
      const bool inlet = end == SurfaceRegion::inlet, outlet = end == SurfaceRegion::outlet;
      if (link.bothFluid)
        addThin(link);
      else if ((inlet || outlet) && ends_.inlet == LatticeEnds::Inlet::periodic)
        addPassage(link);
      else if (outlet || (inlet && ends_.inlet == LatticeEnds::Inlet::pressure))
        addPressure(link, inlet ? ends_.inletDensity : 0.0);
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
    return slot(layout_.place(moved(l.coordinates, l.direction)), l.direction);
  }
  /// The node with z taken round from one end to the other.
  Step wrapped(Step n) const {
    const int layers = layout_.size()[2];
    n[2] = (n[2] + layers) % layers;
    return n;
  }

  void addWall(const SurfaceLink& link, bool inlet) {
    LatticeBoundary::WallLink wall{near(link), far(link), near(link), near(link), 0.0, 0.0};
    Step behind = moved(link.coordinates, d3q19::opposite(link.direction));
    bool interpolable = link.interpolable;
    if (ends_.inlet == LatticeEnds::Inlet::periodic && (behind[2] < 0 || behind[2] >= layout_.size()[2])) {
      behind = wrapped(behind);
      interpolable = fluidAt_.contains(layout_.place(behind));
    }
    // Without a node behind (a gap one node wide) the wall is taken to be half a link away
    double q = 0.5;
    if (interpolable && rule_ == WallRule::interpolated) {
      q = link.q;
      wall.behind = slot(layout_.place(behind), d3q19::opposite(link.direction));
      wall.here = slot(link.node, link.direction);
      wall.k = (1.0 - 2.0 * q) / (1.0 + 2.0 * q);
    }
    if (inlet) {
      const Step& c = d3q19::c[link.direction];
      const Vec3 direction(c[0], c[1], c[2]);
      const Vec3 u =
          ends_.velocity(lattice_.frame.position(link.coordinates) + link.q * lattice_.frame.dx * direction);
      wall.source = -12.0 * d3q19::weight(link.direction) / (1.0 + 2.0 * q) * direction.dot(u);
    }
    result_.wall.push_back(wall);
  }

  void addThin(const SurfaceLink& link) {
    if (link.direction % 2 == 1) result_.thin.push_back({near(link), far(link)});
  }

  void addPressure(const SurfaceLink& link, double density) {
    const auto [entry, isNew] =
        pressureNode_.try_emplace(link.node, static_cast<std::uint32_t>(result_.pressureNodes.size()));
    if (isNew) {
      LatticeBoundary::PressureNode node{link.node, {}};
      for (int i = 0; i < d3q19::directions; ++i)
        node.neighbour[static_cast<std::size_t>(i)] = layout_.place(moved(link.coordinates, i));
      result_.pressureNodes.push_back(node);
    }
    result_.pressure.push_back({near(link), far(link), entry->second, link.direction, density});
  }

  void addPassage(const SurfaceLink& link) {
    const int opposite = d3q19::opposite(link.direction);
    const Step target = wrapped(moved(link.coordinates, link.direction));
    const std::uint32_t place = layout_.place(target);
    if (!fluidAt_.contains(place)) {
      addWallBeyondEnd(link);
      return;
    }
    result_.passages.push_back({near(link), slot(layout_.place(moved(target, opposite)), opposite), far(link),
                                slot(place, link.direction)});
  }

  /// A link that leaves through an end and would meet the wall on the other side of it. Where the lumen goes
  /// on beyond its ends as it was before, the wall is as far as for the same link one layer further in.
  void addWallBeyondEnd(const SurfaceLink& link) {
    SurfaceLink inner = link;
    inner.coordinates[2] -= d3q19::c[link.direction][2];
    inner.node = layout_.place(inner.coordinates);
    const auto key = [](const SurfaceLink& l) { return std::tuple(l.direction, l.node); };
    const auto found = std::lower_bound(lattice_.links.begin(), lattice_.links.end(), inner,
                                        [&](const auto& a, const auto& b) { return key(a) < key(b); });
    if (found == lattice_.links.end() || key(*found) != key(inner))
      throw std::invalid_argument("a periodic flow needs equal ends: the lumen's inlet and outlet differ");
    SurfaceLink wall = link;
    wall.q = found->q;
    addWall(wall, false);
  }

  const LumenLattice& lattice_;
  const ColumnLayout& layout_;
  WallRule rule_;
  const LatticeEnds& ends_;
  FluidPlaces fluidAt_;
  std::unordered_map<std::uint32_t, std::uint32_t> pressureNode_;
  LatticeBoundary result_;
};

}  // namespace

LatticeBoundary makeBoundary(const LumenLattice& lattice, const std::vector<SurfaceRegion>& region,
                             WallRule rule, const LatticeEnds& ends) {
  return BoundaryMaker(lattice, rule, ends).make(region);
}

}  // namespace restenosis

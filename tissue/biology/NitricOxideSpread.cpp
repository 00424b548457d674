#include "tissue/biology/NitricOxideSpread.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nanoflann.hpp>
#include <vector>

#include "tissue/agents/Chunks.h"
#include "tissue/biology/CellCycle.h"

namespace restenosis {
namespace {

/// The cells that produce nitric oxide, with its logarithm.
struct Sources {
  std::vector<Vec3> places;
  std::vector<double> logarithm;
  double largest = -std::numeric_limits<double>::infinity();

  void add(const Vec3& place, double nitricOxide) {
    places.push_back(place);
    logarithm.push_back(std::log(nitricOxide));
    largest = std::max(largest, logarithm.back());
  }
  std::size_t kdtree_get_point_count() const { return places.size(); }
  double kdtree_get_pt(std::size_t n, std::size_t axis) const {
    return places[n][static_cast<Eigen::Index>(axis)];
  }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};

/// Finds the largest logarithm that reaches a place: the search goes no farther than the strongest source
/// would need to be to exceed what has been found.
class StrongestSource {
 public:
  using DistanceType = double;

  StrongestSource(const Sources& sources, double reach, double least)
      : sources_(sources), reach_(reach), best_(least) {}

  double best() const { return best_; }
  std::size_t size() const { return 0; }
  bool full() const { return true; }
  void init() {}
  bool addPoint(double squaredDistance, std::size_t n) {
    best_ = std::max(best_, sources_.logarithm[n] - std::sqrt(squaredDistance) / reach_);
    return true;
  }
  double worstDist() const {
    const double farthest = reach_ * (sources_.largest - best_);
    return farthest > 0 ? farthest * farthest : 0;
  }

 private:
  const Sources& sources_;
  double reach_, best_;
};

}  // namespace

void spreadNitricOxide(AgentStore& agents, double reach, double negligible) {
  using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Sources>, Sources, 3>;
  Sources sources;
  for (Index i = 0; i < agents.size(); ++i)
    if (agents.nitricOxide[i] > negligible) sources.add(agents.position(i), agents.nitricOxide[i]);
  if (sources.places.empty()) return;
  Tree tree(3, sources);
  tree.buildIndex();

  const double least = std::log(negligible);
  forEachInChunks(agents.size(), [&](std::size_t k) {
    const auto i = static_cast<Index>(k);
    if (!CellCycle::cycles(agents, i) || !agents.has(i, synthetic)) return;
    const double own = agents.nitricOxide[i];
    StrongestSource strongest(sources, reach, own > negligible ? std::log(own) : least);
    const Vec3 place = agents.position(i);
    tree.findNeighbors(strongest, place.data(), nanoflann::SearchParams());
    if (strongest.best() > (own > negligible ? std::log(own) : least))
      agents.nitricOxide[i] = std::exp(strongest.best());
  });
}

}  // namespace restenosis

#include "bridge/flow/foam/InsidePoint.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>
#include <vector>

#include "bridge/surface/InnerBalls.h"

namespace restenosis {
namespace {

/// Places of the wall that are tried, until two are found that leave room (assumed).
constexpr int mostTried = 64;
/// Smallest ball that is looked for, over the finest cell (assumed).
constexpr double smallestBall = 0.05;
/// From a cell's centre, over its edges: a place that is on no face of a smaller cell.
const Vec3 offCentre(0.0131, 0.0173, 0.0371);

struct Candidate {
  Vec3 place;
  double margin;  ///< how much nearer than the surface the farthest centre of a cell that may hold it is [m]
};

class InsideSearch {
 public:
  InsideSearch(const TriSurface& lumen, const BackgroundBlock& block, int core, int finest)
      : lumen_(lumen),
        block_(block),
        core_(core),
        finest_(finest),
        coreCell_(block.cell(core).norm()),
        surface_(lumen.vertices, lumen.triangles),
        balls_(facetsOf(lumen), 2 * coreCell_, smallestBall * block.cell(finest).minCoeff()) {}

  double coreCell() const { return coreCell_; }  ///< its diagonal [m]

  /// The best place in the ball that touches the surface at a triangle.
  std::optional<Candidate> at(std::size_t triangle) const {
    const auto ball = balls_.at(lumen_.centre(triangle), lumen_.areaVector(triangle).normalized());
    if (!ball) return std::nullopt;
    std::optional<Candidate> best;
    for (int halvings = core_; halvings <= finest_; ++halvings) {
      const Vec3 place =
          block_.cellCentre(ball->centre, halvings) + block_.cell(halvings).cwiseProduct(offCentre);
      // Within the ball no wall is between its centre, which is inside, and the place
      if ((place - ball->centre).norm() >= ball->radius) continue;
      const Candidate candidate{place, margin(place)};
      if (!best || candidate.margin > best->margin) best = candidate;
    }
    return best;
  }

 private:
  static std::vector<Facet> facetsOf(const TriSurface& lumen) {
    std::vector<Facet> facets;
    facets.reserve(lumen.triangles.size());
    for (std::size_t t = 0; t < lumen.triangles.size(); ++t)
      if (const auto& [a, b, c] = lumen.triangles[t]; lumen.areaVector(t).norm() > 0.0)
        facets.push_back({lumen.vertices[a], lumen.vertices[b], lumen.vertices[c]});
    return facets;
  }

  double margin(const Vec3& place) const {
    const double free = surface_.at(place).distance;
    double least = free;
    for (int halvings = core_; halvings <= finest_; ++halvings) {
      const Vec3 centre = block_.cellCentre(place, halvings);
      // A cell that the surface surely passes through is halved further
      const bool surelyCut = surface_.at(centre).distance < 0.5 * block_.cell(halvings).minCoeff();
      if (surelyCut && halvings < finest_) continue;
      least = std::min(least, free - (centre - place).norm());
    }
    return least;
  }

  const TriSurface& lumen_;
  const BackgroundBlock& block_;
  int core_, finest_;
  double coreCell_;
  NearestTriangle surface_;
  InnerBalls balls_;
};

/// Sides of the lumen, spread over their area: the n-th at the n-th multiple of the golden section.
std::vector<std::size_t> spreadSides(const TriSurface& lumen, int count) {
  std::vector<double> areaBefore(lumen.triangles.size() + 1, 0.0);
  for (std::size_t t = 0; t < lumen.triangles.size(); ++t) {
    const bool side = lumen.region[t] == SurfaceRegion::wall || lumen.region[t] == SurfaceRegion::strut;
    areaBefore[t + 1] = areaBefore[t] + (side ? lumen.areaVector(t).norm() : 0.0);
  }
  std::vector<std::size_t> sides;
  for (int n = 1; n <= count; ++n) {
    const double share = std::fmod(n * (std::numbers::phi - 1), 1.0);
    const auto after = std::ranges::upper_bound(areaBefore, share * areaBefore.back());
    if (after != areaBefore.end()) sides.push_back(static_cast<std::size_t>(after - areaBefore.begin()) - 1);
  }
  return sides;
}

}  // namespace

std::array<Vec3, 2> insidePoints(const TriSurface& lumen, const BackgroundBlock& block, int core,
                                 int finest) {
  const InsideSearch search(lumen, block, core, finest);
  std::vector<Candidate> found;
  const auto byMargin = [](const Candidate& a, const Candidate& b) { return a.margin > b.margin; };
  // Of the second only that it is elsewhere and leaves room as well
  const auto apart = [&](const Candidate& other) {
    return (other.place - found.front().place).norm() > search.coreCell();
  };
  const auto enough = [&] {
    std::ranges::stable_sort(found, byMargin);
    const auto second = std::ranges::find_if(found, apart);
    return second != found.end() && second->margin >= search.coreCell();
  };
  for (const std::size_t side : spreadSides(lumen, mostTried)) {
    if (const auto candidate = search.at(side)) found.push_back(*candidate);
    if (!found.empty() && enough()) break;
  }
  if (found.empty()) throw std::invalid_argument("the lumen is too narrow everywhere to hold a cell");
  const auto second = std::ranges::find_if(found, apart);
  return {found.front().place, second == found.end() ? found.front().place : second->place};
}

}  // namespace restenosis

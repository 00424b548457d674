#include "bridge/surface/SolidCover.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "bridge/surface/InnerBalls.h"
#include "bridge/surface/PointTree.h"
#include "bridge/surface/SurfacePieces.h"

namespace restenosis {
namespace {

/// Longest side of the facets that a surface is looked at by, over the radius of the ball there.
constexpr double facetSize = 1.0;
/// How far beside its own ball another one may stand to cover a place, over the radius.
constexpr double besides = 0.65;
const double deeper = std::hypot(1.0, besides) - 1;  ///< how much deeper it is then, over the radius

/// A place of the surface and the ball that comes nearest to it.
struct Sample {
  Vec3 place;
  Ball ball;
  double gap;  ///< between them [m]
};

struct Samples {
  std::vector<Sample> all;
  double area = 0, tooThin = 0;  ///< [m^2]
};

double longestSide(const Facet& f) {
  return std::max({(f[0] - f[1]).norm(), (f[1] - f[2]).norm(), (f[2] - f[0]).norm()});
}

/// The halves of a facet, cut at the middle of its longest side.
std::array<Facet, 2> halves(const Facet& f) {
  const double length = longestSide(f);
  for (int k = 0; k < 3; ++k) {
    const Vec3 &a = f[k], &b = f[(k + 1) % 3], &c = f[(k + 2) % 3];
    if ((a - b).norm() < length) continue;
    const Vec3 middle = 0.5 * (a + b);
    return {Facet{a, middle, c}, Facet{middle, b, c}};
  }
  return {f, f};
}

void cut(const Facet& facet, double longest, std::vector<Facet>& result) {
  if (longestSide(facet) <= longest) return result.push_back(facet);
  for (const Facet& half : halves(facet)) cut(half, longest, result);
}

void sample(const Facet& facet, const InnerBalls& balls, Samples& result) {
  const Vec3 areaVector = 0.5 * (facet[1] - facet[0]).cross(facet[2] - facet[0]);
  const double area = areaVector.norm();
  if (area <= 0) return;
  const Vec3 place = (facet[0] + facet[1] + facet[2]) / 3.0;
  const auto ball = balls.at(place, areaVector / area);
  if (ball && longestSide(facet) > facetSize * ball->radius * (1 + 1e-9)) {
    for (const Facet& half : halves(facet)) sample(half, balls, result);
    return;
  }
  result.area += area;
  if (ball)
    result.all.push_back({place, *ball, (place - ball->centre).norm() - ball->radius});
  else
    result.tooThin += area;
}

/// The facets of each piece of a surface, none longer than `longest`. Orienting changes nothing of a surface
/// whose normals point outwards.
std::vector<std::vector<Facet>> facetsOfPieces(TriSurface solid, double longest) {
  const std::vector<std::uint32_t> pieceOf = orientPieces(solid);
  std::vector<std::vector<Facet>> pieces;
  for (std::size_t n = 0; n < solid.triangles.size(); ++n) {
    const auto& t = solid.triangles[n];
    if (pieceOf[n] >= pieces.size()) pieces.resize(pieceOf[n] + 1);
    cut({solid.vertices[t[0]], solid.vertices[t[1]], solid.vertices[t[2]]}, longest, pieces[pieceOf[n]]);
  }
  return pieces;
}

void samplePiece(const std::vector<Facet>& facets, double largest, double least, Samples& result) {
  const InnerBalls balls(facets, largest, least);
  constexpr std::size_t chunk = 256;
  std::vector<Samples> chunks((facets.size() + chunk - 1) / chunk);
#pragma omp parallel for schedule(dynamic)
  for (std::size_t n = 0; n < chunks.size(); ++n)
    for (std::size_t k = n * chunk; k < std::min(facets.size(), (n + 1) * chunk); ++k)
      sample(facets[k], balls, chunks[n]);
  for (const Samples& part : chunks) {
    result.all.insert(result.all.end(), part.all.begin(), part.all.end());
    result.area += part.area;
    result.tooThin += part.tooThin;
  }
}

/// Each piece is looked at alone: where pieces overlap, the nearest face of all does not say whether a place
/// is inside one of them, but what is inside one is inside them all together.
Samples sampleSurface(const TriSurface& solid, double largest, double least) {
  Samples result;
  for (const auto& facets : facetsOfPieces(solid, facetSize * largest))
    samplePiece(facets, largest, least, result);
  return result;
}

/// Finds the samples that a ball covers: those that it comes as near to as their own ball, or little less.
class Coverage {
 public:
  explicit Coverage(const std::vector<Sample>& samples) : samples_(samples), tree_(placesOf(samples)) {
    for (const Sample& s : samples) reach_ = std::max(reach_, gapAllowed(s));
  }
  std::vector<std::size_t> of(const Ball& ball) const {
    std::vector<std::size_t> covered;
    for (const auto& near : tree_.within(ball.centre, (ball.radius + reach_) * (1 + 1e-9)))
      if (near.distance - ball.radius <= gapAllowed(samples_[near.index])) covered.push_back(near.index);
    return covered;
  }

 private:
  static double gapAllowed(const Sample& s) { return s.gap + deeper * s.ball.radius; }
  static std::vector<Vec3> placesOf(const std::vector<Sample>& samples) {
    std::vector<Vec3> places;
    places.reserve(samples.size());
    for (const Sample& s : samples) places.push_back(s.place);
    return places;
  }

  const std::vector<Sample>& samples_;
  PointTree tree_;
  double reach_ = 0;
};

/// Enough of the samples' balls to cover all samples.
std::vector<Ball> choose(const std::vector<Sample>& samples) {
  // Corners and edges first, which only their own balls can cover; faces are filled in between.
  std::vector<std::size_t> order(samples.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto exposure = [&](std::size_t n) { return samples[n].gap / samples[n].ball.radius; };
  std::ranges::stable_sort(order, [&](auto a, auto b) { return exposure(a) > exposure(b); });
  const Coverage coverage(samples);
  std::vector<std::uint32_t> coveredBy(samples.size(), 0);
  std::vector<std::pair<std::size_t, std::vector<std::size_t>>> chosen;
  for (const std::size_t n : order) {
    if (coveredBy[n] > 0) continue;
    chosen.emplace_back(n, coverage.of(samples[n].ball));
    for (const std::size_t covered : chosen.back().second) ++coveredBy[covered];
  }
  // What the later ones have made superfluous.
  std::vector<Ball> balls;
  for (const auto& [n, covered] : chosen) {
    const bool needed = std::ranges::any_of(covered, [&](auto k) { return coveredBy[k] == 1; });
    if (needed)
      balls.push_back(samples[n].ball);
    else
      for (const std::size_t k : covered) --coveredBy[k];
  }
  return balls;
}

}  // namespace

SolidCover coverSolid(const TriSurface& solid, double largest, double least) {
  const Samples samples = sampleSurface(solid, largest, least);
  return {choose(samples.all), samples.area > 0 ? samples.tooThin / samples.area : 1.0};
}

}  // namespace restenosis

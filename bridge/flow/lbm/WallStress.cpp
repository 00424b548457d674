#include "bridge/flow/lbm/WallStress.h"

#include <algorithm>
#include <cmath>

#include "bridge/flow/TrianglePieces.h"
#include "bridge/flow/lbm/SmoothNormals.h"
#include "bridge/flow/lbm/WallDistances.h"
#include "bridge/surface/PointTree.h"

namespace restenosis {
namespace {

/// Nodes count up to this distance [spacings], for values and for derivatives (assumed;
/// docs/results/flow.md).
constexpr double valueRadius = 2.5, ratioRadius = 2.25, derivativeRadius = 3.0;
/// Nodes with a link to the wall count less in values: their stress carries the wall rule's error.
constexpr double linkedWeight = 0.1;
/// Where there are fewer than `fewestNear`, those up to this distance.
constexpr double largeRadius = 5.0;
constexpr std::size_t fewestNear = 6;
/// The stress is taken once a triangle, and for longer ones than this [spacings] once a piece: drawings have
/// long triangles where a lumen is straight (assumed).
constexpr double longestPiece = 4.0;
/// Faces whose nodes are held at a time: all would take a gigabyte in a stented vessel.
constexpr std::size_t batchOfFaces = 8192;
/// An edge is near where the normals of faces within this distance [spacings] differ by more than 35 degrees.
constexpr double edgeReach = 3.0, edgeCosine = 0.819;

class NodeFinder {
 public:
  explicit NodeFinder(const LumenLattice& lattice) : frame_(lattice.frame) {
    const auto& n = frame_.size;
    place_.assign(
        static_cast<std::size_t>(n[0]) * static_cast<std::size_t>(n[1]) * static_cast<std::size_t>(n[2]),
        none);
    for (const NodeRun& run : lattice.layout.runs())
      for (std::uint32_t k = 0; k < run.count; ++k)
        place_[at(run.x, run.y, run.z + static_cast<int>(k))] = run.first + k;
    linked_.assign(lattice.layout.places(), false);
    for (const auto& link : lattice.links) linked_[link.node] = true;
  }

  /// Fluid nodes within `reach` spacings on the lumen's side of a face, in the order of the lattice.
  /// Those with a link to the wall weigh `ofLinked` times what others do. Fills `found`.
  void around(const Vec3& centre, const Vec3& normal, double reach, double ofLinked,
              std::vector<NearNode>& found) const {
    const Vec3 middle = (centre - frame_.origin) / frame_.dx;
    const auto low = [&](int d) { return std::max(0, static_cast<int>(std::ceil(middle[d] - reach))); };
    const auto high = [&](int d) {
      return std::min(frame_.size[static_cast<std::size_t>(d)] - 1,
                      static_cast<int>(std::floor(middle[d] + reach)));
    };
    found.clear();
    for (int x = low(0); x <= high(0); ++x)
      for (int y = low(1); y <= high(1); ++y)
        for (int z = low(2); z <= high(2); ++z) {
          const Vec3 offset = Vec3(x, y, z) - middle;
          const double distance = offset.norm() / reach;
          if (distance >= 1.0 || offset.dot(normal) > 0.0) continue;
          const std::uint32_t place = place_[at(x, y, z)];
          if (place == none) continue;
          found.push_back({place, offset, (linked_[place] ? ofLinked : 1.0) * (1.0 - distance * distance)});
        }
  }

 private:
  static constexpr std::uint32_t none = 0xffffffff;
  std::size_t at(int x, int y, int z) const {
    return (static_cast<std::size_t>(x) * static_cast<std::size_t>(frame_.size[1]) +
            static_cast<std::size_t>(y)) *
               static_cast<std::size_t>(frame_.size[2]) +
           static_cast<std::size_t>(z);
  }
  LatticeFrame frame_;
  std::vector<std::uint32_t> place_;
  std::vector<bool> linked_;  ///< by place: whether a link of it meets the surface
};

/// Where the wall bends within a few spacings.
class EdgeFinder {
 public:
  EdgeFinder(const std::vector<Vec3>& centres, const std::vector<Vec3>& normals)
      : tree_(centres), normals_(normals) {}
  bool near(const Vec3& centre, const Vec3& normal, double reach) const {
    return tree_.anyWithin(centre, reach,
                           [&](std::size_t face) { return normals_[face].dot(normal) < edgeCosine; });
  }

 private:
  PointTree tree_;
  const std::vector<Vec3>& normals_;
};

double reachOf(StressRule rule) {
  switch (rule) {
    case StressRule::gradient:
      return derivativeRadius;
    case StressRule::ratio:
      return ratioRadius;
    default:
      return valueRadius;
  }
}

}  // namespace

WallStress::WallStress(const TriSurface& lumen, const LumenLattice& lattice, StressRule rule,
                       double viscosity, const std::optional<ViscosityLaw>& thinning)
    : viscosity_(viscosity), thinning_(thinning) {
  listFaces(lumen, rule, lattice.frame.dx);
  decideRules(rule, lattice.frame.dx);
  const NodeFinder finder(lattice);
  WallDistances distances(lumen, lattice);
  NodesOfFaces found(std::min(batchOfFaces, faces_.size()));
  for (std::size_t begin = 0; begin < faces_.size(); begin += found.size()) {
    const std::span<Face> batch =
        std::span(faces_).subspan(begin, std::min(found.size(), faces_.size() - begin));
#pragma omp parallel for schedule(dynamic, 64)
    for (std::size_t f = 0; f < batch.size(); ++f) {
      const double ofLinked = batch[f].ofVelocity() ? 1.0 : linkedWeight;
      finder.around(batch[f].centre, batch[f].normal, reachOf(batch[f].rule), ofLinked, found[f]);
      if (found[f].size() < fewestNear)
        finder.around(batch[f].centre, batch[f].normal, largeRadius, ofLinked, found[f]);
    }
    for (std::size_t f = 0; f < batch.size(); ++f)
      if (batch[f].ofVelocity()) distances.add(batch[f].centre, found[f]);
    distances.find();
    weigh(batch, found, distances);
    keep(batch, found);
  }
  numberNodes(lattice.layout.places());
}

void WallStress::listFaces(const TriSurface& lumen, StressRule rule, double dx) {
  const SmoothNormals normals(lumen);
  for (std::size_t i = 0; i < lumen.triangles.size(); ++i) {
    if (lumen.region[i] != SurfaceRegion::wall && lumen.region[i] != SurfaceRegion::strut) continue;
    const auto& [a, b, c] = lumen.triangles[i];
    forEachPieceOf({lumen.vertices[a], lumen.vertices[b], lumen.vertices[c]}, longestPiece * dx,
                   [&](const Vec3& centre, double area) {
                     if (area > 0.0)
                       faces_.push_back({centre, normals.at(i), area, lumen.region[i], 0, 0, rule});
                   });
  }
}

void WallStress::decideRules(StressRule rule, double dx) {
  if (rule != StressRule::adaptive) return;
  std::vector<Vec3> centres, normals;
  for (const Face& f : faces_) centres.push_back(f.centre), normals.push_back(f.normal);
  const EdgeFinder edges(centres, normals);
#pragma omp parallel for schedule(dynamic, 64)
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    Face& face = faces_[f];
    const bool edge = edges.near(face.centre, face.normal, edgeReach * dx);
    face.rule = !edge                                 ? StressRule::fitted
                : face.region == SurfaceRegion::strut ? StressRule::gradient
                                                      : StressRule::ratio;
  }
}

void WallStress::weigh(std::span<const Face> faces, NodesOfFaces& found, const WallDistances& distances) {
#pragma omp parallel for schedule(dynamic, 64)
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (found[f].empty()) continue;
    switch (faces[f].rule) {
      case StressRule::gradient:
        distances.set(found[f]);
        keepFacing(found[f], faces[f].normal);
        fitWallDerivative(found[f], faces[f].normal);
        break;
      case StressRule::ratio:
        distances.set(found[f]);
        fitWallRatio(found[f]);
        break;
      case StressRule::nearest:
        keepNearest(found[f]);
        break;
      default:
        fitValue(found[f]);
    }
  }
}

void WallStress::keep(std::span<Face> faces, const NodesOfFaces& found) {
  for (std::size_t f = 0; f < faces.size(); ++f) {
    faces[f].first = static_cast<std::uint32_t>(terms_.size());
    faces[f].count = static_cast<std::uint32_t>(found[f].size());
    if (found[f].empty()) ++bare_;
    for (const auto& n : found[f]) terms_.push_back({n.place, static_cast<float>(n.weight)});
  }
}

void WallStress::numberNodes(std::size_t places) {
  std::vector<std::uint32_t> number(places, 0);  // by place: of nodes_, where it is one
  for (const Term& term : terms_) number[term.node] = 1;
  for (std::size_t place = 0; place < places; ++place)
    if (number[place] != 0) {
      number[place] = static_cast<std::uint32_t>(nodes_.size());
      nodes_.push_back(static_cast<std::uint32_t>(place));
    }
  for (Term& term : terms_) term.node = number[term.node];
}

Vec3 WallStress::traction(std::size_t face, const std::vector<NodeValue>& values, double pascal) const {
  const Face& f = faces_[face];
  NodeValue s{};
  for (std::uint32_t t = f.first; t < f.first + f.count; ++t)
    for (std::size_t k = 0; k < s.size(); ++k) s[k] += double{terms_[t].weight} * values[terms_[t].node][k];
  const Vec3& n = f.normal;
  const Vec3 rate(s[6], s[7], s[8]);
  Vec3 onWall = (thinning_ ? (*thinning_)((rate - rate.dot(n) * n).norm()) : viscosity_) * rate;
  if (!f.ofVelocity())
    onWall = -Vec3(s[0] * n.x() + s[3] * n.y() + s[4] * n.z(), s[3] * n.x() + s[1] * n.y() + s[5] * n.z(),
                   s[4] * n.x() + s[5] * n.y() + s[2] * n.z());
  return pascal * (onWall - onWall.dot(n) * n);
}

std::vector<WallFace> WallStress::wall(const std::vector<NodeValue>& values, double pascal) const {
  std::vector<WallFace> result;
  result.reserve(faces_.size());
  for (std::size_t f = 0; f < faces_.size(); ++f)
    result.push_back({faces_[f].centre, faces_[f].area, traction(f, values, pascal), faces_[f].region});
  return result;
}

std::vector<WallStress::NodeValue> WallStress::nodeValues(const LatticeFlowBase& flow) const {
  std::vector<NodeValue> result(nodes_.size());
#pragma omp parallel for schedule(static)
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    const NodeState state = flow.state(nodes_[n]);
    std::copy(state.stress.begin(), state.stress.end(), result[n].begin());
    std::copy(state.velocity.begin(), state.velocity.end(), result[n].begin() + 6);
  }
  return result;
}

}  // namespace restenosis

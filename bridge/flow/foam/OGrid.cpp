#include "bridge/flow/foam/OGrid.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <stdexcept>

#include "bridge/flow/foam/AxisView.h"

namespace restenosis {
namespace {

/// Planes and rays of the view that a cell has, and how far the rays lie apart of which a corner takes the
/// mean; and how much of a lumen may lie in undercuts.
constexpr int planesACell = 3, raysACell = 6, raysApart = 2;
constexpr double mostUndercut = 0.01;
/// Corners of the core, over the radius; how far its sides bulge, from a square (0) to a circle (1); size of
/// the layer at the wall over that at the core; and where a lumen that is narrow on one side leaves the core,
/// over the radius there. All assumed.
constexpr double coreRadius = 0.6, coreBulge = 0.5, wallOverCore = 0.4, widestCore = 0.8;
/// The core follows a lumen smoothed over this part of a turn and of the radius along the axis (assumed).
constexpr double smoothTurn = 0.125, smoothRadii = 0.5;

using Quad = std::array<int, 4>;

/// A cut across the mesh: points by number, quads counter-clockwise.
class PlaneLayout {
 public:
  explicit PlaneLayout(const OGridSize& size) : side_(size.around / 4), layers_(size.layers) {
    const auto corner = [&](int a, int b) { return b * (side_ + 1) + a; };
    for (int b = 0; b < side_; ++b)
      for (int a = 0; a < side_; ++a)
        quads_.push_back({corner(a, b), corner(a + 1, b), corner(a + 1, b + 1), corner(a, b + 1)});
    for (int layer = 0; layer < layers_; ++layer)
      for (int j = 0; j < around(); ++j)
        quads_.push_back(
            {onRing(layer, j), onRing(layer + 1, j), onRing(layer + 1, j + 1), onRing(layer, j + 1)});
  }
  int side() const { return side_; }
  int around() const { return 4 * side_; }
  int layers() const { return layers_; }
  int points() const { return (side_ + 1) * (side_ + 1) + layers_ * around(); }
  const std::vector<Quad>& quads() const { return quads_; }

  /// The number of a point of the core: column and row.
  int inCore(int a, int b) const { return b * (side_ + 1) + a; }
  /// The number of a point of ring 0, the core's edge, to `layers`, the wall; the first ray points to the
  /// core's upper right corner.
  int onRing(int ring, int j) const {
    j %= around();
    if (ring > 0) return (side_ + 1) * (side_ + 1) + (ring - 1) * around() + j;
    const int along = j % side_;
    switch (j / side_) {
      case 0:
        return inCore(side_ - along, side_);
      case 1:
        return inCore(0, side_ - along);
      case 2:
        return inCore(along, 0);
      default:
        return inCore(side_, along);
    }
  }

 private:
  int side_, layers_;
  std::vector<Quad> quads_;
};

double angleOf(int j, int around) { return 2.0 * std::numbers::pi * j / around + 0.25 * std::numbers::pi; }

/// Radii of the wall by plane and ray of the mesh [m].
class WallRadii {
 public:
  WallRadii(const AxisView& view, const OGridSize& size) : around_(size.around), planes_(size.along + 1) {
    const int shift = view.angles() / 8;  // to the first ray, at 45 degrees
    // A polygon of the same area
    const double x = 2.0 * std::numbers::pi / around_, wider = std::sqrt(x / std::sin(x));
    for (int k = 0; k < planes_; ++k)
      for (int j = 0; j < around_; ++j) {
        double sum = 0.0;
        int rays = 0;
        for (int dk = -1; dk <= 1; ++dk) {
          const int plane = planesACell * k + dk;
          // The rim of an end is its own
          const bool end = k == 0 || k == planes_ - 1;
          if (end ? dk != 0 : plane < 0 || plane > view.planes()) continue;
          for (int dj = -1; dj <= 1; ++dj, ++rays)
            sum +=
                view.radius(plane, (shift + raysACell * j + raysApart * dj + view.angles()) % view.angles());
        }
        values_.push_back(wider * sum / rays);
      }
  }
  double at(int plane, int ray) const {
    return values_[static_cast<std::size_t>(plane) * static_cast<std::size_t>(around_) +
                   static_cast<std::size_t>(((ray % around_) + around_) % around_)];
  }
  int planes() const { return planes_; }
  int around() const { return around_; }

  /// Running means over so many planes and rays to either side, twice.
  WallRadii smoothed(int planes, int rays) const {
    WallRadii result = *this;
    for (int pass = 0; pass < 2; ++pass) {
      const WallRadii before = result;
      for (int k = 0; k < planes_; ++k)
        for (int j = 0; j < around_; ++j) {
          double sum = 0.0;
          for (int d = -rays; d <= rays; ++d) sum += before.at(k, j + d);
          result.set(k, j, sum / (2 * rays + 1));
        }
      const WallRadii around = result;
      for (int k = 0; k < planes_; ++k)
        for (int j = 0; j < around_; ++j) {
          double sum = 0.0;
          for (int d = -planes; d <= planes; ++d) sum += around.at(std::clamp(k + d, 0, planes_ - 1), j);
          result.set(k, j, sum / (2 * planes + 1));
        }
    }
    return result;
  }

 private:
  void set(int plane, int ray, double value) {
    values_[static_cast<std::size_t>(plane) * static_cast<std::size_t>(around_) +
            static_cast<std::size_t>(ray)] = value;
  }
  int around_, planes_;
  std::vector<double> values_;
};

/// Where the layers lie between the core, 0, and the wall, 1.
std::vector<double> layerPlaces(int layers) {
  const double ratio = layers > 1 ? std::pow(wallOverCore, 1.0 / (layers - 1)) : 1.0;
  std::vector<double> places{0.0};
  double thickness = 1.0;
  for (int l = 0; l < layers; ++l, thickness *= ratio) places.push_back(places.back() + thickness);
  for (double& place : places) place /= places.back();
  places.back() = 1.0;
  return places;
}

/// The edge of the core, over the radius, in a direction.
double coreEdge(double angle) {
  const double square =
      std::numbers::sqrt2 / 2 / std::max(std::abs(std::cos(angle)), std::abs(std::sin(angle)));
  return coreRadius * (coreBulge + (1.0 - coreBulge) * square);
}

/// The points of one plane, from the axis: those of the rings, and the core filled between its edges.
void placePlane(const PlaneLayout& section, const WallRadii& wall, const WallRadii& smooth, int plane,
                const Vec3& axis, std::span<Vec3> points) {
  const auto layers = layerPlaces(section.layers());
  for (int j = 0; j < section.around(); ++j) {
    const double angle = angleOf(j, section.around()), radius = wall.at(plane, j);
    const Vec3 ray(std::cos(angle), std::sin(angle), 0.0);
    const double edge = std::min(coreEdge(angle) * smooth.at(plane, j), widestCore * radius);
    for (int l = 0; l <= section.layers(); ++l)
      points[section.onRing(l, j)] = axis + (edge + layers[l] * (radius - edge)) * ray;
  }
  const int n = section.side();
  const auto at = [&](int a, int b) -> Vec3& { return points[section.inCore(a, b)]; };
  for (int b = 1; b < n; ++b)
    for (int a = 1; a < n; ++a) {
      const double u = static_cast<double>(a) / n, v = static_cast<double>(b) / n;
      at(a, b) =
          (1 - v) * at(a, 0) + v * at(a, n) + (1 - u) * at(0, b) + u * at(n, b) -
          ((1 - u) * (1 - v) * at(0, 0) + u * (1 - v) * at(n, 0) + u * v * at(n, n) + (1 - u) * v * at(0, n));
    }
}

struct Face {
  std::int32_t owner, neighbour;  ///< cells; -1 where there is none
  std::array<std::int32_t, 4> corners;
};

/// The faces of the section drawn along the planes: inner ones in OpenFOAM's order, then wall, inlet, outlet.
class Extrusion {
 public:
  Extrusion(const PlaneLayout& section, int along) : section_(section), along_(along) {
    addAcross();
    addAlong();
    std::ranges::sort(inner_, {}, [](const Face& f) { return std::pair(f.owner, f.neighbour); });
  }
  void fill(PolyMesh& mesh) const {
    mesh.faceStart = {0};
    const auto append = [&](const std::vector<Face>& faces) {
      for (const Face& f : faces) {
        mesh.faceCorners.insert(mesh.faceCorners.end(), f.corners.begin(), f.corners.end());
        mesh.faceStart.push_back(static_cast<std::int32_t>(mesh.faceCorners.size()));
        mesh.owner.push_back(f.owner);
        if (f.neighbour >= 0) mesh.neighbour.push_back(f.neighbour);
      }
    };
    append(inner_);
    for (const auto& [name, faces] : {std::pair{"inlet", &inlet_}, {"outlet", &outlet_}, {"wall", &wall_}}) {
      mesh.patches.push_back({name, mesh.faces(), faces->size()});
      append(*faces);
    }
  }

 private:
  std::int32_t cell(int plane, std::size_t quad) const {
    return plane * static_cast<std::int32_t>(section_.quads().size()) + static_cast<std::int32_t>(quad);
  }
  std::int32_t point(int plane, int number) const { return plane * section_.points() + number; }

  /// Faces in the planes.
  void addAcross() {
    for (int plane = 0; plane <= along_; ++plane)
      for (std::size_t q = 0; q < section_.quads().size(); ++q) {
        Face face{-1, -1, {}};
        for (std::size_t k = 0; k < 4; ++k) face.corners[k] = point(plane, section_.quads()[q][k]);
        if (plane == 0) {  // a face looks out of its owner
          std::ranges::reverse(face.corners);
          face.owner = cell(0, q);
          inlet_.push_back(face);
        } else {
          face.owner = cell(plane - 1, q);
          if (plane < along_) face.neighbour = cell(plane, q);
          (plane < along_ ? inner_ : outlet_).push_back(face);
        }
      }
  }

  /// Faces that lie along the axis, on the edges of the section's quads.
  void addAlong() {
    struct Side {
      int a, b;  ///< counter-clockwise around its quad
      std::size_t quad;
      std::pair<int, int> edge() const { return {std::min(a, b), std::max(a, b)}; }
    };
    std::vector<Side> sides;
    for (std::size_t q = 0; q < section_.quads().size(); ++q)
      for (std::size_t k = 0; k < 4; ++k)
        sides.push_back({section_.quads()[q][k], section_.quads()[q][(k + 1) % 4], q});
    std::ranges::sort(sides, {}, [](const Side& s) { return std::pair(s.edge(), s.quad); });
    for (std::size_t i = 0; i < sides.size(); ++i) {
      const Side& s = sides[i];
      const bool shared = i + 1 < sides.size() && s.edge() == sides[i + 1].edge();
      for (int plane = 0; plane < along_; ++plane) {
        Face face{cell(plane, s.quad),
                  shared ? cell(plane, sides[i + 1].quad) : -1,
                  {point(plane, s.a), point(plane, s.b), point(plane + 1, s.b), point(plane + 1, s.a)}};
        (shared ? inner_ : wall_).push_back(face);
      }
      if (shared) ++i;
    }
  }

  const PlaneLayout& section_;
  int along_;
  std::vector<Face> inner_, inlet_, outlet_, wall_;
};

}  // namespace

PolyMesh oGrid(const TriSurface& lumen, const OGridSize& size) {
  const AxisView view(lumen, planesACell * size.along, raysACell * size.around);
  if (view.undercut() > mostUndercut)
    throw std::invalid_argument(fmt::format(
        "{:.2g} % of the lumen's sides lie behind others, seen from its axis", 100 * view.undercut()));
  const PlaneLayout section(size);
  const WallRadii wall(view, size);
  double mean = 0.0;
  for (int k = 0; k < wall.planes(); ++k)
    for (int j = 0; j < wall.around(); ++j) mean += wall.at(k, j) / (wall.planes() * wall.around());
  const double step = (view.axis(view.planes()) - view.axis(0)).norm() / size.along;
  const WallRadii smooth =
      wall.smoothed(static_cast<int>(smoothRadii * mean / step), static_cast<int>(smoothTurn * size.around));
  PolyMesh mesh;
  mesh.points.resize(static_cast<std::size_t>(section.points()) * static_cast<std::size_t>(wall.planes()));
  for (int k = 0; k < wall.planes(); ++k)
    placePlane(
        section, wall, smooth, k, view.axis(planesACell * k),
        std::span(mesh.points).subspan(static_cast<std::size_t>(k) * section.points(), section.points()));
  Extrusion(section, size.along).fill(mesh);
  return mesh;
}

}  // namespace restenosis

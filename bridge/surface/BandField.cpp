#include "bridge/surface/BandField.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace restenosis {
namespace {

/// A coordinate as the lower node of its interval and the fraction of the way to the next.
struct Between {
  int lower;
  double fraction;
  Between(double coordinate, double origin, double spacing, int nodes) {
    const double s = std::clamp((coordinate - origin) / spacing, 0.0, static_cast<double>(nodes - 1));
    lower = std::min(static_cast<int>(s), nodes - 2);
    fraction = s - lower;
  }
};

/// The cell of a grid in which a point is, or the nearest one.
struct Cell {
  Between x, y, z;
  Cell(const LumenGrid& g, const Vec3& point)
      : x(point.x(), g.x(0), g.spacing, g.nx),
        y(point.y(), g.y(0), g.spacing, g.ny),
        z(point.z(), 0.0, g.spacingZ, g.nz) {}
};

double mix(double a, double b, double t) { return a + t * (b - a); }

}  // namespace

BandField::BandField(const LumenGrid& grid)
    : grid_(grid),
      blocksX_((grid_.nx + cells - 2) / cells),
      blocksY_((grid_.ny + cells - 2) / cells),
      layers_(static_cast<std::size_t>((grid_.nz + cells - 2) / cells)) {}

BandField::BandField(const LumenGrid& grid, const FillPlane& fill) : BandField(grid) {
#pragma omp parallel
  {
    std::vector<float> values(side * grid_.planeSize());
    Planes planes;
#pragma omp for schedule(dynamic, 1)
    for (std::size_t layer = 0; layer < layers_.size(); ++layer) {
      for (int n = 0; n < side; ++n) {
        const int k = nodeOf(layer, n);
        float* plane = values.data() + n * grid_.planeSize();
        if (n > 0 && k == nodeOf(layer, n - 1)) {
          planes[n] = planes[n - 1];
        } else {
          fill(k, plane);
          planes[n] = plane;
        }
      }
      setLayer(layer, planes, nullptr);
    }
  }
}

BandField::BandField(const GridField& field, const BandField* where) : BandField(field.grid) {
#pragma omp parallel for schedule(dynamic, 1)
  for (std::size_t layer = 0; layer < layers_.size(); ++layer) {
    Planes planes;
    for (int n = 0; n < side; ++n) planes[n] = field.values.data() + grid_.row(0, nodeOf(layer, n));
    setLayer(layer, planes, where ? &where->layers_[layer] : nullptr);
  }
}

int BandField::nodeOf(std::size_t layer, int plane) const {
  return std::min(static_cast<int>(layer) * cells + plane, grid_.nz - 1);
}

void BandField::setLayer(std::size_t number, const Planes& planes, const Layer* where) {
  Layer layer;  // a thread's own: those in layers_ share cache lines
  layer.blocks.resize(static_cast<std::size_t>(blocksX_) * blocksY_);
  const auto forEachNode = [&](std::size_t block, const auto& f) {
    const auto [i0, j0] = firstOf(block);
    for (const float* plane : planes)
      for (int j = 0; j < side; ++j) {
        const float* row = plane + grid_.row(std::min(j0 + j, grid_.ny - 1), 0);
        for (int i = 0; i < side; ++i) f(row[std::min(i0 + i, grid_.nx - 1)]);
      }
  };
  std::uint32_t kept = 0;
  for (std::size_t b = 0; b < layer.blocks.size(); ++b) {
    const auto [i0, j0] = firstOf(b);
    const float value = planes[0][grid_.row(j0, 0) + static_cast<std::size_t>(i0)];
    bool all = true;
    if (!where || !where->isEven(b)) forEachNode(b, [&](float v) { all &= v == value; });
    layer.blocks[b] = {.number = all ? even : kept++, .value = value};
  }
  layer.values.reserve(kept * ofBlock);
  for (std::size_t b = 0; b < layer.blocks.size(); ++b)
    if (!layer.isEven(b)) forEachNode(b, [&](float v) { layer.values.push_back(v); });
  layers_[number] = std::move(layer);
}

BandField::Node BandField::firstOf(std::size_t block) const {
  const auto b = static_cast<int>(block);
  return {b % blocksX_ * cells, b / blocksX_ * cells};
}

BandField::Place BandField::placeOf(int i, int j, int k) const {
  const int bi = std::min(i / cells, blocksX_ - 1), bj = std::min(j / cells, blocksY_ - 1),
            bk = std::min(k / cells, static_cast<int>(layers_.size()) - 1);
  const auto value =
      (static_cast<std::size_t>(k - bk * cells) * side + (j - bj * cells)) * side + (i - bi * cells);
  return {layers_[bk], static_cast<std::size_t>(bj) * blocksX_ + bi, value};
}

std::size_t BandField::kept() const {
  std::size_t count = 0;
  for (const Layer& layer : layers_) count += layer.values.size();
  return count;
}

float BandField::operator()(int i, int j, int k) const {
  const Place place = placeOf(i, j, k);
  return place.isEven() ? place.evenValue() : *place.values();
}

void BandField::copyRow(int j, int k, float* to) const {
  for (int i = 0; i < grid_.nx; i += cells) {
    const Place place = placeOf(i, j, k);
    const int count = std::min(cells, grid_.nx - i);
    if (place.isEven()) {
      std::fill_n(to + i, count, place.evenValue());
    } else {
      std::copy_n(place.values(), count, to + i);
    }
  }
}

bool BandField::evenAround(const Vec3& point) const {
  const Cell cell(grid_, point);
  return placeOf(cell.x.lower, cell.y.lower, cell.z.lower).isEven();
}

double BandField::at(const Vec3& point) const {
  Vec3 unused;
  return at(point, unused);
}

double BandField::at(const Vec3& point, Vec3& gradient) const {
  const LumenGrid& g = grid_;
  const auto [a, b, c] = Cell(g, point);
  const Place place = placeOf(a.lower, b.lower, c.lower);
  if (place.isEven()) {
    gradient.setZero();
    return place.evenValue();
  }
  const float* v = place.values();
  const float* over = v + ofPlane;
  const double v00 = mix(v[0], v[1], a.fraction), v10 = mix(v[side], v[side + 1], a.fraction),
               v01 = mix(over[0], over[1], a.fraction), v11 = mix(over[side], over[side + 1], a.fraction);
  const double low = mix(v00, v10, b.fraction), high = mix(v01, v11, b.fraction);
  gradient.x() = mix(mix(v[1] - v[0], v[side + 1] - v[side], b.fraction),
                     mix(over[1] - over[0], over[side + 1] - over[side], b.fraction), c.fraction) /
                 g.spacing;
  gradient.y() = mix(v10 - v00, v11 - v01, c.fraction) / g.spacing;
  gradient.z() = (high - low) / g.spacingZ;
  return mix(low, high, c.fraction);
}

double BandField::evenRadius(int k) const {
  const Place axis = placeOf((grid_.nx - 1) / 2, (grid_.ny - 1) / 2, k);
  if (!axis.isEven()) return 0;
  double radius = std::numeric_limits<double>::infinity();
  for (std::size_t b = 0; b < axis.layer.blocks.size(); ++b) {
    if (axis.layer.isEven(b) && axis.layer.blocks[b].value == axis.evenValue()) continue;
    const auto [i, j] = firstOf(b);
    // The nearest point of a block to the axis; points beyond the grid belong to the blocks at its rim
    const auto nearest = [](double low, double high) { return low > 0 ? low : high < 0 ? -high : 0.0; };
    radius = std::min(
        radius, std::hypot(nearest(grid_.x(i), grid_.x(i + cells)), nearest(grid_.y(j), grid_.y(j + cells))));
  }
  return radius;
}

double BandField::inPlane(double x, double y, int k) const {
  const LumenGrid& g = grid_;
  const Between a(x, g.x(0), g.spacing, g.nx), b(y, g.y(0), g.spacing, g.ny);
  const Place place = placeOf(a.lower, b.lower, k);
  if (place.isEven()) return place.evenValue();
  const float* v = place.values();
  return mix(mix(v[0], v[1], a.fraction), mix(v[side], v[side + 1], a.fraction), b.fraction);
}

}  // namespace restenosis

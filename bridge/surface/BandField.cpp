#include "BandField.h"

#include <algorithm>

namespace restenosis {
namespace {

/// A coordinate as the lower node of its interval and the fraction of the way to the next.
struct Place {
  int lower;
  double fraction;
  Place(double coordinate, double origin, double spacing, int nodes) {
    const double s = std::clamp((coordinate - origin) / spacing, 0.0, static_cast<double>(nodes - 1));
    lower = std::min(static_cast<int>(s), nodes - 2);
    fraction = s - lower;
  }
};

/// The cell of a grid in which a point is, or the nearest one.
struct Cell {
  Place x, y, z;
  Cell(const LumenGrid& g, const Vec3& point)
      : x(point.x(), g.x(0), g.spacing, g.nx),
        y(point.y(), g.y(0), g.spacing, g.ny),
        z(point.z(), 0.0, g.spacingZ, g.nz) {}
};

double mix(double a, double b, double t) { return a + t * (b - a); }

}  // namespace

BandField::BandField(const GridField& field, const BandField* where)
    : grid_(field.grid),
      blocksX_((grid_.nx + cells - 2) / cells),
      blocksY_((grid_.ny + cells - 2) / cells),
      blocksZ_((grid_.nz + cells - 2) / cells),
      blocks_(static_cast<std::size_t>(blocksX_) * blocksY_ * blocksZ_) {
  const LumenGrid& g = grid_;
  const auto forEachNode = [&](std::size_t block, const auto& f) {
    const Node first = firstOf(block);
    for (int k = 0; k < side; ++k)
      for (int j = 0; j < side; ++j) {
        const float* row =
            field.values.data() + g.row(std::min(first.j + j, g.ny - 1), std::min(first.k + k, g.nz - 1));
        for (int i = 0; i < side; ++i) f(row[std::min(first.i + i, g.nx - 1)]);
      }
  };
#pragma omp parallel for schedule(static)
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    const Node first = firstOf(b);
    const float value = field.values[g.index(first.i, first.j, first.k)];
    bool all = true;
    if (!where || where->blocks_[b].number != even) forEachNode(b, [&](float v) { all &= v == value; });
    blocks_[b] = {.number = all ? even : 0, .value = value};
  }
  std::uint32_t kept = 0;
  for (Block& block : blocks_)
    if (block.number != even) block.number = kept++;
  values_.resize(kept * volume);
#pragma omp parallel for schedule(static)
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    if (blocks_[b].number == even) continue;
    float* to = values_.data() + blocks_[b].number * volume;
    forEachNode(b, [&](float v) { *to++ = v; });
  }
}

BandField::Node BandField::firstOf(std::size_t block) const {
  const auto b = static_cast<int>(block);
  return {b % blocksX_ * cells, b / blocksX_ % blocksY_ * cells, b / blocksX_ / blocksY_ * cells};
}

std::size_t BandField::blockOf(int i, int j, int k) const {
  const int bi = std::min(i / cells, blocksX_ - 1), bj = std::min(j / cells, blocksY_ - 1),
            bk = std::min(k / cells, blocksZ_ - 1);
  return (static_cast<std::size_t>(bk) * blocksY_ + bj) * blocksX_ + bi;
}

const float* BandField::from(std::size_t block, int i, int j, int k) const {
  const Node first = firstOf(block);
  return values_.data() + blocks_[block].number * volume + (k - first.k) * plane +
         static_cast<std::size_t>((j - first.j) * side + i - first.i);
}

float BandField::operator()(int i, int j, int k) const {
  const std::size_t block = blockOf(i, j, k);
  return isEven(block) ? blocks_[block].value : *from(block, i, j, k);
}

void BandField::copyRow(int j, int k, float* to) const {
  for (int i = 0; i < grid_.nx; i += cells) {
    const std::size_t block = blockOf(i, j, k);
    const int count = std::min(cells, grid_.nx - i);
    if (isEven(block)) {
      std::fill_n(to + i, count, blocks_[block].value);
    } else {
      std::copy_n(from(block, i, j, k), count, to + i);
    }
  }
}

bool BandField::evenAround(const Vec3& point) const {
  const Cell cell(grid_, point);
  return isEven(blockOf(cell.x.lower, cell.y.lower, cell.z.lower));
}

double BandField::at(const Vec3& point) const {
  Vec3 unused;
  return at(point, unused);
}

double BandField::at(const Vec3& point, Vec3& gradient) const {
  const LumenGrid& g = grid_;
  const auto [a, b, c] = Cell(g, point);
  const std::size_t block = blockOf(a.lower, b.lower, c.lower);
  if (isEven(block)) {
    gradient.setZero();
    return blocks_[block].value;
  }
  const float* v = from(block, a.lower, b.lower, c.lower);
  const float* over = v + plane;
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

double BandField::inPlane(double x, double y, int k) const {
  const LumenGrid& g = grid_;
  const Place a(x, g.x(0), g.spacing, g.nx), b(y, g.y(0), g.spacing, g.ny);
  const std::size_t block = blockOf(a.lower, b.lower, k);
  if (isEven(block)) return blocks_[block].value;
  const float* v = from(block, a.lower, b.lower, k);
  return mix(mix(v[0], v[1], a.fraction), mix(v[side], v[side + 1], a.fraction), b.fraction);
}

}  // namespace restenosis

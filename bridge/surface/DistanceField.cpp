#include "bridge/surface/DistanceField.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "tissue/agents/Capacity.h"

namespace restenosis {
namespace {

/// The part of a node range within `reach` of a coordinate; empty when last < first.
struct Range {
  int first, last;
  Range(double coordinate, double reach, double origin, double spacing, int nodes)
      : first(std::max(0, static_cast<int>(std::ceil((coordinate - reach - origin) / spacing)))),
        last(std::min(nodes - 1, static_cast<int>(std::floor((coordinate + reach - origin) / spacing)))) {}
};

/// The spheres and their mirror images across the ends, as far as they reach into the grid, and for every
/// plane of nodes which of them touch it, as a list in compressed rows.
class PlaneLists {
 public:
  PlaneLists(const LumenGrid& grid, std::vector<Ball> spheres, double clip);
  /// Lowers the values of plane k, its nodes row by row, to the distances to the spheres, where these are
  /// below `clip`.
  void lower(int k, float* plane) const;

 private:
  const LumenGrid& grid_;
  double clip_;
  std::vector<Ball> spheres_;
  std::vector<std::size_t> start_;
  std::vector<std::uint32_t> member_;
};

PlaneLists::PlaneLists(const LumenGrid& grid, std::vector<Ball> spheres, double clip)
    : grid_(grid), clip_(clip), spheres_(std::move(spheres)) {
  const LumenGrid& g = grid_;
  const std::size_t count = spheres_.size();
  const auto mirror = [&](const Ball& s, double z) {
    if (z + s.radius + clip < 0 || z - s.radius - clip > g.length) return;
    growCapacity(spheres_, spheres_.size() + 1);
    spheres_.push_back({{s.centre.x(), s.centre.y(), z}, s.radius});
  };
  for (std::size_t n = 0; n < count; ++n) {
    const Ball s = spheres_[n];
    mirror(s, -s.centre.z());
    mirror(s, 2 * g.length - s.centre.z());
  }
  start_.assign(g.nz + 1, 0);
  const auto planes = [&](const Ball& s) {
    return Range(s.centre.z(), s.radius + clip, 0.0, g.spacingZ, g.nz);
  };
  for (const Ball& s : spheres_) {
    const Range r = planes(s);
    for (int k = r.first; k <= r.last; ++k) ++start_[k + 1];
  }
  for (int k = 0; k < g.nz; ++k) start_[k + 1] += start_[k];
  member_.resize(start_.back());
  auto next = start_;
  for (std::uint32_t n = 0; n < spheres_.size(); ++n) {
    const Range r = planes(spheres_[n]);
    for (int k = r.first; k <= r.last; ++k) member_[next[k]++] = n;
  }
}

constexpr int vectorWidth = 8;  ///< floats that most processors work on at once

void PlaneLists::lower(int k, float* plane) const {
  const LumenGrid& g = grid_;
  for (std::size_t n = start_[k]; n < start_[k + 1]; ++n) {
    const Ball& s = spheres_[member_[n]];
    const double reach = s.radius + clip_, dz = g.z(k) - s.centre.z();
    const double inPlane = reach * reach - dz * dz;
    if (inPlane < 0) continue;
    // The square around the circle within reach, its sides rounded up to whole vectors: nodes outside are
    // farther than the clip and keep their value, and to find the circle's ends in each row would cost more.
    const double halfWidth = std::sqrt(inPlane);
    const Range rows(s.centre.y(), halfWidth, g.y(0), g.spacing, g.ny);
    const Range nodes(s.centre.x(), halfWidth, g.x(0), g.spacing, g.nx);
    const int count =
        std::min(g.nx - nodes.first, (nodes.last - nodes.first + vectorWidth) / vectorWidth * vectorWidth);
    const float offset = static_cast<float>(g.x(nodes.first) - s.centre.x());
    const float spacing = static_cast<float>(g.spacing), radius = static_cast<float>(s.radius);
    for (int j = rows.first; j <= rows.last; ++j) {
      const double dy = g.y(j) - s.centre.y();
      const float fixedPart = static_cast<float>(dy * dy + dz * dz);
      float* row = plane + static_cast<std::size_t>(j) * g.nx + nodes.first;
#pragma omp simd
      for (int i = 0; i < count; ++i) {
        const float dx = offset + static_cast<float>(i) * spacing;
        const float distance = std::sqrt(dx * dx + fixedPart) - radius;
        row[i] = distance < row[i] ? distance : row[i];
      }
    }
  }
}

}  // namespace

GridField sphereDistance(const LumenGrid& g, std::vector<Ball> spheres, double clip) {
  const PlaneLists lists(g, std::move(spheres), clip);
  GridField field(g, static_cast<float>(clip));
#pragma omp parallel for schedule(dynamic, 1)
  for (int k = 0; k < g.nz; ++k) lists.lower(k, field.values.data() + g.row(0, k));
  return field;
}

BandField sphereBand(const LumenGrid& g, std::vector<Ball> spheres, double clip) {
  const PlaneLists lists(g, std::move(spheres), clip);
  return BandField(g, [&](int k, float* plane) {
    std::fill_n(plane, g.planeSize(), static_cast<float>(clip));
    lists.lower(k, plane);
  });
}

BandField strutBand(const LumenGrid& g, std::span<const StrutSegment> struts, double clip) {
  const std::vector<StrutDistance> distances(struts.begin(), struts.end());
  return BandField(g, [&](int k, float* plane) {
    std::fill_n(plane, g.planeSize(), static_cast<float>(clip));
    for (std::size_t n = 0; n < struts.size(); ++n) {
      const StrutSegment& s = struts[n];
      // No point of a segment is farther from its centreline than this.
      const double reach = clip + 0.5 * std::hypot(s.width, s.thickness) + s.overlap;
      if (g.z(k) < std::min(s.a.z(), s.b.z()) - reach || g.z(k) > std::max(s.a.z(), s.b.z()) + reach)
        continue;
      const Vec3 middle = 0.5 * (s.a + s.b), half = 0.5 * (s.a - s.b).cwiseAbs();
      const Range rows(middle.y(), half.y() + reach, g.y(0), g.spacing, g.ny);
      const Range nodes(middle.x(), half.x() + reach, g.x(0), g.spacing, g.nx);
      for (int j = rows.first; j <= rows.last; ++j) {
        float* row = plane + g.row(j, 0);
        for (int i = nodes.first; i <= nodes.last; ++i)
          row[i] = std::min(row[i], static_cast<float>(distances[n](g.node(i, j, k))));
      }
    }
  });
}

void closeByBall(GridField& field, double probe, double clip) {
  const LumenGrid& g = field.grid;
  std::vector<float>& d = field.values;
  const auto p = static_cast<float>(probe);
  std::vector<std::vector<Ball>> samples(g.nz);
#pragma omp parallel for schedule(dynamic, 1)
  for (int k = 0; k < g.nz; ++k) {
    std::vector<Ball> plane;  // of the thread's own: those in `samples` share cache lines
    for (int j = 0; j < g.ny; ++j) {
      for (int i = 0; i < g.nx; ++i) {
        const float here = d[g.index(i, j, k)] - p;
        auto cross = [&](int di, int dj, int dk) {
          const float there = d[g.index(i + di, j + dj, k + dk)] - p;
          if ((here >= 0) == (there >= 0)) return;
          const double t = here / (static_cast<double>(here) - there);
          plane.push_back({g.node(i, j, k) + t * (g.node(i + di, j + dj, k + dk) - g.node(i, j, k)), probe});
        };
        if (i + 1 < g.nx) cross(1, 0, 0);
        if (j + 1 < g.ny) cross(0, 1, 0);
        if (k + 1 < g.nz) cross(0, 0, 1);
      }
    }
    samples[k] = std::move(plane);
  }
  std::vector<Ball> balls;
  std::size_t count = 0;
  for (const auto& plane : samples) count += plane.size();
  balls.reserve(count);
  for (auto& plane : samples) {
    balls.insert(balls.end(), plane.begin(), plane.end());
    plane = {};
  }
  const PlaneLists lists(g, std::move(balls), clip);
  const auto limit = static_cast<float>(clip);
#pragma omp parallel
  {
    std::vector<float> swept(g.planeSize());
#pragma omp for schedule(dynamic, 1)
    for (int k = 0; k < g.nz; ++k) {
      std::ranges::fill(swept, limit);
      lists.lower(k, swept.data());
      float* plane = d.data() + g.row(0, k);
      for (std::size_t n = 0; n < swept.size(); ++n)
        plane[n] = std::clamp(plane[n] >= p ? plane[n] : -swept[n], -limit, limit);
    }
  }
}

void blur(GridField& field, double sigma) {
  if (sigma <= 0) return;
  const LumenGrid& g = field.grid;
  auto kernel = [&](double spacing) {
    const int reach = static_cast<int>(std::ceil(3 * sigma / spacing));
    std::vector<float> weights(2 * reach + 1);
    double sum = 0;
    for (int m = -reach; m <= reach; ++m) sum += std::exp(-0.5 * std::pow(m * spacing / sigma, 2));
    for (int m = -reach; m <= reach; ++m)
      weights[m + reach] = static_cast<float>(std::exp(-0.5 * std::pow(m * spacing / sigma, 2)) / sum);
    return weights;
  };
  const auto across = kernel(g.spacing), along = kernel(g.spacingZ);
  const int reach = static_cast<int>(across.size()) / 2, reachZ = static_cast<int>(along.size()) / 2;
#pragma omp parallel
  {
    std::vector<float> padded(g.nx + 2 * reach), plane(g.planeSize());
#pragma omp for schedule(static)
    for (int k = 0; k < g.nz; ++k) {
      for (int j = 0; j < g.ny; ++j) {  // along x
        const float* row = field.values.data() + g.row(j, k);
        for (int i = 0; i < g.nx + 2 * reach; ++i) padded[i] = row[std::clamp(i - reach, 0, g.nx - 1)];
        float* target = plane.data() + static_cast<std::size_t>(j) * g.nx;
        std::fill_n(target, g.nx, 0.0F);
        for (int m = 0; m <= 2 * reach; ++m)
          for (int i = 0; i < g.nx; ++i) target[i] += across[m] * padded[i + m];
      }
      for (int j = 0; j < g.ny; ++j) {  // along y
        float* target = field.values.data() + g.row(j, k);
        std::fill_n(target, g.nx, 0.0F);
        for (int m = -reach; m <= reach; ++m) {
          const float* row = plane.data() + static_cast<std::size_t>(std::clamp(j + m, 0, g.ny - 1)) * g.nx;
          for (int i = 0; i < g.nx; ++i) target[i] += across[m + reach] * row[i];
        }
      }
    }
    // Along z, in place: the rows behind are kept as they were, those ahead still are.
    const int kept = reachZ + 1;
    std::vector<float> before(static_cast<std::size_t>(kept) * g.nx);
    const auto was = [&](int k) { return before.data() + static_cast<std::size_t>(k % kept) * g.nx; };
#pragma omp for schedule(static)
    for (int j = 0; j < g.ny; ++j) {
      for (int k = 0; k < g.nz; ++k) {
        float* target = field.values.data() + g.row(j, k);
        std::copy_n(target, g.nx, was(k));
        std::fill_n(target, g.nx, 0.0F);
        for (int m = -reachZ; m <= reachZ; ++m) {
          int source = std::abs(k + m);
          if (source >= g.nz) source = 2 * (g.nz - 1) - source;
          source = std::clamp(source, 0, g.nz - 1);
          const float* from = source <= k ? was(source) : field.values.data() + g.row(j, source);
          for (int i = 0; i < g.nx; ++i) target[i] += along[m + reachZ] * from[i];
        }
      }
    }
  }
}

void uniteRounded(GridField& field, const BandField& other, double width) {
  const LumenGrid& g = field.grid;
  const auto w = static_cast<float>(width);
#pragma omp parallel
  {
    std::vector<float> row(g.nx);
#pragma omp for schedule(static)
    for (int k = 0; k < g.nz; ++k)
      for (int j = 0; j < g.ny; ++j) {
        other.copyRow(j, k, row.data());
        float* values = field.values.data() + g.row(j, k);
        for (int i = 0; i < g.nx; ++i) {
          const float a = values[i], b = row[i];
          const float overlap = std::max(0.0F, w - std::abs(a - b));
          values[i] = std::min(a, b) - (w > 0 ? overlap * overlap / (4 * w) : 0.0F);
        }
      }
  }
}

}  // namespace restenosis

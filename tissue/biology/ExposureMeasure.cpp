#include "tissue/biology/ExposureMeasure.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace restenosis {

ExposureMeasure::ExposureMeasure(const ContactInhibitionParameters& p)
    : range_(p.exposureRange), cellCover_(p.cellCover), laminaCover_(p.laminaCover) {
  const auto n = static_cast<double>(p.directions);
  const double goldenAngle = std::numbers::pi * (3 - std::sqrt(5.0));
  for (std::int64_t k = 0; k < p.directions; ++k) {
    const auto turn = static_cast<double>(k);
    const double height = 1 - (2 * turn + 1) / n;
    const double ring = std::sqrt(1 - height * height);
    x_.push_back(ring * std::cos(goldenAngle * turn));
    y_.push_back(ring * std::sin(goldenAngle * turn));
    z_.push_back(height);
  }
  // A threshold meant to be a whole number of directions must not fall short of it by rounding.
  largestInhibited_ = static_cast<std::int64_t>(std::floor(p.exposureThreshold * n + 1e-9));
}

double ExposureMeasure::share(double radius, std::span<const ContactNeighbour> neighbours) const {
  return static_cast<double>(freeDirections(radius, neighbours, 0)) / static_cast<double>(x_.size());
}

bool ExposureMeasure::exposed(double radius, std::span<const ContactNeighbour> neighbours) const {
  return freeDirections(radius, neighbours, largestInhibited_) > largestInhibited_;
}

/// Counts the free directions; may stop early once no more than `enough` are left.
std::int64_t ExposureMeasure::freeDirections(double radius, std::span<const ContactNeighbour> neighbours,
                                             std::int64_t enough) const {
  constexpr int countEvery = 8;
  const std::size_t n = x_.size();
  thread_local std::vector<std::int64_t> free;
  free.assign(n, 1);

  int sinceCount = 0;
  for (const ContactNeighbour& neighbour : neighbours) {
    const double distance = neighbour.distance;
    if (distance <= 0 || distance > range_ * (radius + neighbour.radius)) continue;
    const bool lamina = neighbour.kind == AgentKind::iel || neighbour.kind == AgentKind::eel;
    const double sheet = lamina ? neighbour.facing * neighbour.facing : 0.0;
    const double cover = cellCover_ + (laminaCover_ - cellCover_) * sheet;
    const double shadow = cover * neighbour.radius;
    // Covered if direction . offset >= D cos(angle) = sqrt(D^2 - shadow^2).
    const double limit = std::sqrt(std::max(0.0, distance * distance - shadow * shadow));
    const double ox = neighbour.offset.x(), oy = neighbour.offset.y(), oz = neighbour.offset.z();
    for (std::size_t k = 0; k < n; ++k) {
      free[k] &= static_cast<std::int64_t>(x_[k] * ox + y_[k] * oy + z_[k] * oz < limit);
    }
    if (++sinceCount == countEvery) {
      sinceCount = 0;
      const auto left = std::accumulate(free.begin(), free.end(), std::int64_t{0});
      if (left <= enough) return left;
    }
  }
  return std::accumulate(free.begin(), free.end(), std::int64_t{0});
}

}  // namespace restenosis

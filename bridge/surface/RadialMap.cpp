#include "bridge/surface/RadialMap.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>

namespace restenosis {
namespace {

/// First root of the field along a ray of direction (c, s) in plane k, or `limit` if there is none. `even`:
/// BandField::evenRadius.
double castRay(const BandField& field, int k, double even, double c, double s, double limit) {
  const double onAxis = field.inPlane(0, 0, k);
  auto value = [&](double r) { return r < even ? onAxis : field.inPlane(r * c, r * s, k); };
  const double least = 0.5 * field.grid().spacing;
  double before = 0, valueBefore = onAxis;
  if (valueBefore <= 0) return 0;
  for (;;) {
    // A distance falls by no more than the way, its trilinear interpolation and rounded joints by less than
    // twice the way.
    const double step = std::max(least, 0.5 * valueBefore);
    double r = before + step, v = value(r);
    if (v <= 0) {
      // Within a step the bilinear function is nearly linear: false position with the Illinois rule.
      double low = before, fLow = valueBefore, high = r, fHigh = v;
      for (int n = 0; n < 20 && high - low > 1e-9 * least; ++n) {
        r = low + (high - low) * fLow / (fLow - fHigh);
        v = value(r);
        if (v > 0) {
          low = r, fLow = v, fHigh *= 0.5;
        } else if (v < 0) {
          high = r, fHigh = v, fLow *= 0.5;
        } else {
          break;
        }
        if (std::abs(v) < 1e-6 * least) break;
      }
      return r;
    }
    if (r >= limit) return limit;
    before = r, valueBefore = v;
  }
}

}  // namespace

RadialMap::RadialMap(const LumenField& field, int angles) : angles_(angles) {
  if (angles < 3) throw std::invalid_argument("a radial map needs at least three angles");
  const LumenGrid& g = field.grid();
  const double limit = g.x(g.nx - 1);
  std::vector<double> cosines, sines;
  for (int a = 0; a < angles; ++a) cosines.push_back(std::cos(angle(a))), sines.push_back(std::sin(angle(a)));
  z_.resize(g.nz);
  radius_.resize(static_cast<std::size_t>(g.nz) * angles);
#pragma omp parallel for schedule(static)
  for (int k = 0; k < g.nz; ++k) {
    z_[k] = g.z(k);
    // Less by what rounding can make of a point on its rim
    const double even = (1 - 1e-9) * field.lumen().evenRadius(k);
    for (int a = 0; a < angles; ++a)
      radius_[static_cast<std::size_t>(k) * angles + a] =
          castRay(field.lumen(), k, even, cosines[static_cast<std::size_t>(a)],
                  sines[static_cast<std::size_t>(a)], limit);
  }
}

RadialMap RadialMap::ofRound(const std::function<double(double)>& radius, double length, double spacing,
                             int angles) {
  const LumenGrid planes(length, spacing, spacing);
  RadialMap map;
  map.angles_ = angles;
  for (int k = 0; k < planes.nz; ++k) {
    map.z_.push_back(planes.z(k));
    map.radius_.insert(map.radius_.end(), angles, radius(planes.z(k)));
  }
  return map;
}

double RadialMap::angle(int index) const { return 2 * std::numbers::pi * index / angles_; }

double RadialMap::interpolate(std::span<const double> byRay, const Vec3& point) const {
  const auto above = std::ranges::upper_bound(z_, point.z());
  const int upper = std::clamp(static_cast<int>(above - z_.begin()), 1, planes() - 1), lower = upper - 1;
  const double along = std::clamp((point.z() - z_[lower]) / (z_[upper] - z_[lower]), 0.0, 1.0);
  const double turn = std::atan2(point.y(), point.x()) / (2 * std::numbers::pi);
  const double ray = (turn < 0 ? turn + 1 : turn) * angles_;
  const int left = static_cast<int>(ray) % angles_, right = (left + 1) % angles_;
  const double around = ray - std::floor(ray);
  const auto inPlane = [&](int plane) {
    const auto row = byRay.subspan(static_cast<std::size_t>(plane) * angles_, angles_);
    return std::lerp(row[left], row[right], around);
  };
  return std::lerp(inPlane(lower), inPlane(upper), along);
}

double RadialMap::planeWeight(int plane) const {
  const int last = planes() - 1;
  return 0.5 * (z_[std::min(plane + 1, last)] - z_[std::max(plane - 1, 0)]);
}

double RadialMap::meanRadius() const {
  double sum = 0, weights = 0;
  for (int k = 0; k < planes(); ++k) {
    for (int a = 0; a < angles_; ++a) sum += planeWeight(k) * radius(k, a) / angles_;
    weights += planeWeight(k);
  }
  return sum / weights;
}

double RadialMap::lumenArea(int plane) const {
  double squares = 0;
  for (int a = 0; a < angles_; ++a) squares += radius(plane, a) * radius(plane, a);
  return std::numbers::pi * squares / angles_;
}

double RadialMap::minimalArea(double from, double to) const {
  double least = HUGE_VAL;
  for (int k = 0; k < planes(); ++k) {
    if (z_[k] >= from && z_[k] <= to) least = std::min(least, lumenArea(k));
  }
  if (least < HUGE_VAL) return least;
  return lumenArea(nearestPlane(0.5 * (from + to)));
}

int RadialMap::nearestPlane(double z) const {
  if (z_.empty()) throw std::invalid_argument("the radial map has no planes");
  const auto nearest = std::ranges::min_element(z_, {}, [z](double plane) { return std::abs(plane - z); });
  return static_cast<int>(nearest - z_.begin());
}

bool RadialMap::comparable(const RadialMap& other) const {
  return angles_ == other.angles_ && z_ == other.z_ && !z_.empty();
}

LumenDisplacement displacement(const RadialMap& before, const RadialMap& after) {
  if (!before.comparable(after)) throw std::invalid_argument("radial maps differ in planes or angles");
  std::vector<double> moved;
  moved.reserve(static_cast<std::size_t>(before.planes()) * before.angles());
  for (int k = 0; k < before.planes(); ++k)
    for (int a = 0; a < before.angles(); ++a)
      moved.push_back(std::abs(after.radius(k, a) - before.radius(k, a)));
  LumenDisplacement d;
  d.mean = std::accumulate(moved.begin(), moved.end(), 0.0) / static_cast<double>(moved.size());
  d.largest = *std::max_element(moved.begin(), moved.end());
  const auto rank = moved.begin() + static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(moved.size() - 1));
  std::nth_element(moved.begin(), rank, moved.end());
  d.robust = *rank;
  return d;
}

Neointima measureNeointima(const RadialMap& reference, const RadialMap& present, double from, double to) {
  if (!reference.comparable(present)) throw std::invalid_argument("radial maps differ in planes or angles");
  Neointima n;
  double weights = 0;
  const int nearest = reference.nearestPlane(0.5 * (from + to));
  from = std::min(from, reference.z(nearest)), to = std::max(to, reference.z(nearest));
  for (int k = 0; k < reference.planes(); ++k) {
    if (reference.z(k) < from || reference.z(k) > to) continue;
    const double weight = reference.planeWeight(k);
    double thickness = 0;
    for (int a = 0; a < reference.angles(); ++a)
      thickness += (reference.radius(k, a) - present.radius(k, a)) / reference.angles();
    const double area = reference.lumenArea(k);
    n.z.push_back(reference.z(k));
    n.thickness.push_back(thickness);
    n.areaFraction.push_back(area > 0 ? 1 - present.lumenArea(k) / area : 0.0);
    n.meanThickness += weight * thickness;
    n.meanAreaFraction += weight * n.areaFraction.back();
    weights += weight;
  }
  n.meanThickness /= weights;
  n.meanAreaFraction /= weights;
  return n;
}

}  // namespace restenosis

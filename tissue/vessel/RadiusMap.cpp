#include "tissue/vessel/RadiusMap.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "tissue/vessel/Cylindrical.h"

namespace restenosis {
namespace {

// Speed only: enough that a bound distinguishes a stent's cells from those beside it.
constexpr int sectors = 64;

}  // namespace

RadiusMap::RadiusMap(const AgentStore& agents, AgentKind kind, double smoothing) {
  using std::numbers::pi;
  double zHigh = -std::numeric_limits<double>::infinity(), radiusSum = 0;
  zLow_ = std::numeric_limits<double>::infinity();
  std::size_t count = 0;
  for (Index i = 0; i < agents.size(); ++i) {
    if (agents.kind[i] != kind) continue;
    zLow_ = std::min(zLow_, agents.z[i]), zHigh = std::max(zHigh, agents.z[i]);
    radiusSum += radiusOf(agents.position(i)), ++count;
  }
  if (count == 0) return;

  const double meanRadius = radiusSum / static_cast<double>(count);
  around_ = std::max(8, static_cast<int>(std::ceil(2 * pi * meanRadius / smoothing)));
  along_ = 1 + static_cast<int>(std::ceil((zHigh - zLow_) / smoothing));
  zStep_ = along_ > 1 ? (zHigh - zLow_) / (along_ - 1) : 1.0;
  values_.assign(static_cast<std::size_t>(around_) * along_, 0.0);
  std::vector<double> weight(values_.size(), 0.0);

  constexpr int reach = 3;  // nodes are one standard deviation apart, so the weight ends at three
  for (Index i = 0; i < agents.size(); ++i) {
    if (agents.kind[i] != kind) continue;
    const Cylindrical c = toCylindrical(agents.position(i));
    const double u = (c.angle / (2 * pi) + 0.5) * around_, v = (c.z - zLow_) / zStep_;
    const int u0 = static_cast<int>(std::lround(u)), v0 = static_cast<int>(std::lround(v));
    for (int along = std::max(0, v0 - reach); along <= std::min(along_ - 1, v0 + reach); ++along) {
      for (int k = u0 - reach; k <= u0 + reach; ++k) {
        const double w = std::exp(-0.5 * ((k - u) * (k - u) + (along - v) * (along - v)));
        const int around = ((k % around_) + around_) % around_;
        value(around, along) += w * c.radius;
        weight[static_cast<std::size_t>(along) * around_ + around] += w;
      }
    }
  }
  for (std::size_t n = 0; n < values_.size(); ++n) {
    if (weight[n] > 0) values_[n] /= weight[n];
  }
  continueIntoGaps(weight);
  bound();
}

RadiusMap::RadiusMap(int around, double zLow, double zStep, std::vector<double> values)
    : around_(around),
      along_(static_cast<int>(values.size()) / around),
      zLow_(zLow),
      zStep_(zStep),
      values_(std::move(values)) {
  bound();
}

void RadiusMap::continueIntoGaps(std::vector<double>& weight) {
  // Each sweep gives a node without agents the mean of its neighbours that have a value; at least one node
  // has.
  for (bool gaps = true; gaps;) {
    gaps = false;
    const auto known = weight;
    const auto isKnown = [&](int around, int along) {
      return known[static_cast<std::size_t>(along) * around_ + around] > 0;
    };
    for (int along = 0; along < along_; ++along) {
      for (int around = 0; around < around_; ++around) {
        if (isKnown(around, along)) continue;
        double sum = 0;
        int neighbours = 0;
        const auto addIfKnown = [&](int a, int b) {
          if (b < 0 || b >= along_ || !isKnown(a, b)) return;
          sum += value(a, b), ++neighbours;
        };
        addIfKnown((around + 1) % around_, along), addIfKnown((around + around_ - 1) % around_, along);
        addIfKnown(around, along - 1), addIfKnown(around, along + 1);
        if (neighbours > 0) {
          value(around, along) = sum / neighbours;
          weight[static_cast<std::size_t>(along) * around_ + around] = 1;
        } else {
          gaps = true;
        }
      }
    }
  }
}

int RadiusMap::sectorOf(double x, double y) {
  const double length = std::abs(x) + std::abs(y);
  if (!(length > 0)) return 0;
  // From -2 to 2 as the angle goes from -pi to pi.
  const double along = y / length, turned = x >= 0 ? along : std::copysign(2.0, y) - along;
  return std::clamp(static_cast<int>((turned + 2) / 4 * sectors), 0, sectors - 1);
}

int RadiusMap::intervalOf(double z) const {
  const double v = (z - zLow_) / zStep_;
  return v > 0 ? static_cast<int>(std::min(v, std::max(0.0, along_ - 2.0))) : 0;
}

void RadiusMap::bound() {
  const int intervals = std::max(1, along_ - 1);
  lowest_.assign(static_cast<std::size_t>(intervals) * sectors, std::numeric_limits<double>::infinity());
  for (int interval = 0; interval < intervals; ++interval) {
    for (int k = 0; k < around_; ++k) {
      const int right = (k + 1) % around_, next = std::min(interval + 1, along_ - 1);
      const double corners =
          std::min({value(k, interval), value(right, interval), value(k, next), value(right, next)});
      const auto sectorOfNode = [&](int node) {
        const double angle = (static_cast<double>(node) / around_ - 0.5) * 2 * std::numbers::pi;
        return sectorOf(std::cos(angle), std::sin(angle));
      };
      // One more on either side, for a rounded angle; the sector at -pi follows that at pi.
      const int first = k == 0 ? 0 : sectorOfNode(k);
      const int last = k + 1 == around_ ? sectors - 1 : sectorOfNode(k + 1);
      for (int s = first - 1; s <= last + 1; ++s) {
        double& low = lowest_[static_cast<std::size_t>(interval) * sectors + (s + sectors) % sectors];
        low = std::min(low, corners * (1 - 1e-9));  // rounding of the interpolation is far below
      }
    }
  }
  lowestOfAll_ = *std::ranges::min_element(lowest_);
}

double RadiusMap::lowestNear(double x, double y, double z) const {
  if (empty()) return std::numeric_limits<double>::infinity();
  return lowest_[static_cast<std::size_t>(intervalOf(z)) * sectors + sectorOf(x, y)];
}

Vec3 RadiusMap::normalAt(const Vec3& point) const {
  const Cylindrical c = toCylindrical(point);
  const double turn = std::numbers::pi / around_, step = zStep_ / 2;
  const auto radius = [this](double angle, double z) { return at(toCartesian({1, angle, z})); };
  const double around = (radius(c.angle + turn, c.z) - radius(c.angle - turn, c.z)) / (2 * turn);
  const double along = (radius(c.angle, c.z + step) - radius(c.angle, c.z - step)) / (2 * step);
  const Vec3 out = radialAt(point);
  return (out - around / at(point) * Vec3(-out.y(), out.x(), 0) - along * Vec3::UnitZ()).normalized();
}

double RadiusMap::at(const Vec3& point) const {
  if (empty()) return std::numeric_limits<double>::infinity();
  const Cylindrical c = toCylindrical(point);
  const double u = (c.angle / (2 * std::numbers::pi) + 0.5) * around_;
  const double v = std::clamp((c.z - zLow_) / zStep_, 0.0, static_cast<double>(along_ - 1));
  const int u0 = static_cast<int>(std::floor(u)), v0 = intervalOf(c.z);
  const double s = u - u0, t = v - v0;
  const int left = u0 % around_, right = (u0 + 1) % around_, next = std::min(v0 + 1, along_ - 1);
  return (1 - t) * ((1 - s) * value(left, v0) + s * value(right, v0)) +
         t * ((1 - s) * value(left, next) + s * value(right, next));
}

}  // namespace restenosis

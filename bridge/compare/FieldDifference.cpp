#include "bridge/compare/FieldDifference.h"

#include <algorithm>
#include <cmath>

namespace restenosis {
namespace {

constexpr double agreement = 1.96;  // standard deviations that 95 % of a normal distribution lie within

double ratio(double a, double b) { return b != 0.0 ? a / b : 0.0; }

}  // namespace

void FieldDifferenceSum::add(double reference, double other, double weight) {
  if (std::isfinite(reference) && std::isfinite(other))
    pairs_.push_back({reference, other, weight});
  else
    ++unknown_;
}

FieldDifference FieldDifferenceSum::result() const {
  FieldDifference d;
  d.count = pairs_.size();
  double squares = 0.0, differences = 0.0;
  for (const Pair& p : pairs_) {
    d.weight += p.weight;
    d.referenceMean += p.weight * p.reference;
    d.mean += p.weight * p.other;
    squares += p.weight * p.reference * p.reference;
    differences += p.weight * (p.other - p.reference) * (p.other - p.reference);
  }
  if (!(d.weight > 0.0)) return d;
  d.referenceMean /= d.weight;
  d.mean /= d.weight;
  d.meanDifference = ratio(d.mean, d.referenceMean) - 1.0;
  d.relativeL2 = std::sqrt(ratio(differences, squares));
  d.bias = d.mean - d.referenceMean;

  double ofReference = 0.0, ofOther = 0.0, joint = 0.0;
  std::vector<std::pair<double, double>> relative;  // magnitude, weight
  for (const Pair& p : pairs_) {
    const double a = p.reference - d.referenceMean, b = p.other - d.mean;
    ofReference += p.weight * a * a;
    ofOther += p.weight * b * b;
    joint += p.weight * a * b;
    relative.emplace_back(2.0 * ratio(std::abs(p.other - p.reference), std::abs(p.other + p.reference)),
                          p.weight);
  }
  d.correlation = ratio(joint, std::sqrt(ofReference * ofOther));
  const double deviation = std::sqrt(std::max(0.0, differences / d.weight - d.bias * d.bias));
  d.lowerLimit = d.bias - agreement * deviation;
  d.upperLimit = d.bias + agreement * deviation;
  std::sort(relative.begin(), relative.end());
  double below = 0.0;
  for (const auto& [magnitude, weight] : relative) {
    below += weight;
    d.relativeP95 = magnitude;
    if (below >= 0.95 * d.weight) break;
  }
  return d;
}

}  // namespace restenosis

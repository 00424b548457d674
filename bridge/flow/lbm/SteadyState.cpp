#include "SteadyState.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace restenosis {
namespace {

constexpr std::size_t ratios = 3;
constexpr double largestRatio = 0.98;

}  // namespace

void SteadyState::add(std::vector<double> sample) {
  if (!last_.empty()) {
    double change = 0.0, norm = 0.0;
    for (std::size_t i = 0; i < sample.size(); ++i) {
      change += (sample[i] - last_[i]) * (sample[i] - last_[i]);
      norm += sample[i] * sample[i];
    }
    changes_.push_back(norm > 0.0 ? std::sqrt(change / norm) : 0.0);
  }
  last_ = std::move(sample);
}

double SteadyState::distance() const {
  if (changes_.size() < ratios + 1) return std::numeric_limits<double>::infinity();
  double ratio = 0.0;
  for (std::size_t i = changes_.size() - ratios; i < changes_.size(); ++i)
    ratio = std::max(ratio, changes_[i - 1] > 0.0 ? changes_[i] / changes_[i - 1] : 0.0);
  ratio = std::min(ratio, largestRatio);
  return changes_.back() * std::max(1.0, ratio / (1.0 - ratio));
}

}  // namespace restenosis

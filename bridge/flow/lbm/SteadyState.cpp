#include "bridge/flow/lbm/SteadyState.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace restenosis {
namespace {

constexpr std::size_t window = 4;
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
  if (changes_.size() < 2 * window) return std::numeric_limits<double>::infinity();
  const auto recent = changes_.end() - window, before = recent - window;
  const double now = std::accumulate(recent, changes_.end(), 0.0),
               then = std::accumulate(before, recent, 0.0);
  const double ratio = then > 0.0 ? std::min(std::pow(now / then, 1.0 / window), largestRatio) : 0.0;
  return *std::max_element(recent, changes_.end()) * std::max(1.0, ratio / (1.0 - ratio));
}

}  // namespace restenosis

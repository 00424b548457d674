#pragma once

#include <algorithm>
#include <chrono>
#include <limits>

namespace restenosis {

/// Wall clock time of one call of f [s]: the best of five rounds of at least a tenth of a second each, so
/// that what else runs on the machine counts least.
template <class F>
double secondsPerCall(F&& f) {
  using Clock = std::chrono::steady_clock;
  double best = std::numeric_limits<double>::infinity();
  f();  // caches and memory pages
  for (int round = 0; round < 5; ++round) {
    const auto begin = Clock::now();
    double seconds = 0;
    int calls = 0;
    while (seconds < 0.1) {
      f();
      ++calls;
      seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    }
    best = std::min(best, seconds / calls);
  }
  return best;
}

}  // namespace restenosis

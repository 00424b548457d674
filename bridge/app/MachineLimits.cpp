#include "bridge/app/MachineLimits.h"

#include <omp.h>

#include <array>
#include <cstring>
#include <vector>

#include "bridge/app/Timing.h"
#include "tissue/agents/Lanes.h"

namespace restenosis {
namespace {

constexpr std::size_t copied = 32 << 20;  // doubles; 256 MiB, beyond any cache
constexpr int lanes = 4;                  // doubles in a group
using Lanes = Numbers<double, lanes>;
constexpr int chains = 12;  // independent ones, enough to fill the pipelines
constexpr int steps = 20000;

double copyRate() {
  std::vector<double> from(copied, 1.0), to(copied, 0.0);
  const double seconds = secondsPerCall([&] {
#pragma omp parallel
    {
      const std::size_t threads = omp_get_num_threads(), thread = omp_get_thread_num();
      const std::size_t begin = copied * thread / threads, end = copied * (thread + 1) / threads;
      std::memcpy(to.data() + begin, from.data() + begin, (end - begin) * sizeof(double));
    }
  });
  return 2.0 * copied * sizeof(double) / seconds;
}

/// Rate at which `step` turns all lanes of all chains over, by all threads together [lanes/s].
template <class Step>
double laneRate(const Step& step) {
  double sum = 0;
  const double seconds = secondsPerCall([&] {
    double part = 0;
#pragma omp parallel reduction(+ : part)
    {
      std::array<Lanes, chains> x;
      for (int c = 0; c < chains; ++c) x[c] = 1.0 + 0.01 * c + 0.001 * sum;
      for (int n = 0; n < steps; ++n) {
        for (Lanes& value : x) value = step(value);
      }
      for (const Lanes& value : x) {
        for (int k = 0; k < lanes; ++k) part += value[k];
      }
    }
    sum = part > 1e6 ? 1 : 0;  // so that the work is not left out
  });
  return static_cast<double>(omp_get_max_threads()) * chains * lanes * steps / seconds;
}

}  // namespace

MachineLimits measureMachine() {
  const double multiply = laneRate([](const Lanes& x) { return x * 0.999 + 0.001; });
  const double roots = laneRate([](const Lanes& x) { return x.sqrt(); });
  return {.copiedBytes = copyRate(), .multiplyAdds = 2 * multiply, .squareRoots = roots};
}

}  // namespace restenosis

#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace restenosis {

/// Loops over fixed pieces of a range: the pieces, and with them the order of every sum, do not depend on the
/// number of threads.
inline constexpr std::ptrdiff_t chunkSize = 256;

/// Calls f(k) for k in [0, count), pieces in parallel.
template <class F>
void forEachInChunks(std::size_t count, F&& f) {
  const auto end = static_cast<std::ptrdiff_t>(count);
#pragma omp parallel for schedule(dynamic) if (end > 2 * chunkSize)
  for (std::ptrdiff_t begin = 0; begin < end; begin += chunkSize) {
    for (std::ptrdiff_t k = begin; k < std::min(end, begin + chunkSize); ++k) f(static_cast<std::size_t>(k));
  }
}

/// Lets f(k, part) add element k to the `part` of its piece, then joins the parts in order: total.join(part).
template <class Sum, class F>
Sum reduceInChunks(std::size_t count, F&& f) {
  const auto end = static_cast<std::ptrdiff_t>(count);
  std::vector<Sum> parts((count + chunkSize - 1) / chunkSize);
#pragma omp parallel for schedule(dynamic) if (end > 2 * chunkSize)
  for (std::ptrdiff_t begin = 0; begin < end; begin += chunkSize) {
    Sum part{};
    for (std::ptrdiff_t k = begin; k < std::min(end, begin + chunkSize); ++k)
      f(static_cast<std::size_t>(k), part);
    parts[begin / chunkSize] = part;
  }
  Sum total{};
  for (const Sum& part : parts) total.join(part);
  return total;
}

}  // namespace restenosis

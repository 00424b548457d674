#pragma once

#include <omp.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "tissue/agents/AgentStore.h"

namespace restenosis {

/// Loops over fixed chunks of a range: the chunks, and with them the order of every sum, do not depend on the
/// number of threads.
inline constexpr std::ptrdiff_t chunkSize = 256;

/// Shorter loops are not worth waking other threads for: those over work, those that only test elements, and
/// those in which each element costs microseconds, which also need smaller chunks to keep all threads busy.
inline constexpr std::ptrdiff_t parallelFrom = 2048, parallelTestFrom = 16384;
inline constexpr std::ptrdiff_t parallelHeavyFrom = 512, heavyChunkSize = 64;

/// Calls f(begin, end) for the chunks [begin, end) of [0, count), in parallel where count >= from. Every
/// thread does the chunks of its own share first, in order, then what is left of the others': what one loop
/// brought into a core's cache the next finds there, and no thread waits for a core that has other work.
template <class F>
void forEachChunk(std::size_t count, F&& f, std::ptrdiff_t from = parallelFrom,
                  std::ptrdiff_t size = chunkSize) {
  const auto all = static_cast<std::ptrdiff_t>(count), chunks = (all + size - 1) / size;
  const auto run = [&](std::ptrdiff_t chunk) {
    f(static_cast<std::size_t>(chunk * size), static_cast<std::size_t>(std::min(all, (chunk + 1) * size)));
  };
  if (all < from || omp_get_max_threads() == 1) {
    for (std::ptrdiff_t chunk = 0; chunk < chunks; ++chunk) run(chunk);
    return;
  }
  struct alignas(64) Share {
    std::atomic<std::ptrdiff_t> next;
    std::ptrdiff_t end;
  };
  std::vector<Share> shares(static_cast<std::size_t>(omp_get_max_threads()));
  const auto threads = static_cast<std::ptrdiff_t>(shares.size());
  for (std::ptrdiff_t t = 0; t < threads; ++t) {
    shares[t].next = chunks * t / threads;
    shares[t].end = chunks * (t + 1) / threads;
  }
#pragma omp parallel
  for (std::ptrdiff_t n = 0; n < threads; ++n) {
    Share& share = shares[(omp_get_thread_num() + n) % threads];
    for (std::ptrdiff_t chunk; (chunk = share.next.fetch_add(1, std::memory_order_relaxed)) < share.end;)
      run(chunk);
  }
}

/// The same for elements that each cost microseconds.
template <class F>
void forEachHeavyChunk(std::size_t count, F&& f) {
  forEachChunk(count, std::forward<F>(f), parallelHeavyFrom, heavyChunkSize);
}

/// Calls f(k) for k in [0, count), chunks in parallel.
template <class F>
void forEachInChunks(std::size_t count, F&& f) {
  forEachChunk(count, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) f(k);
  });
}

/// A reduction: lets f(begin, end, part) add elements [begin, end) to the `part` of a chunk, then joins the
/// parts in order: total.join(part).
template <class Sum, class F>
Sum reduceChunks(std::size_t count, F&& f) {
  std::vector<Sum> parts((count + chunkSize - 1) / chunkSize);
  forEachChunk(count, [&](std::size_t begin, std::size_t end) {
    Sum part{};
    f(begin, end, part);
    parts[begin / chunkSize] = part;
  });
  Sum total{};
  for (const Sum& part : parts) total.join(part);
  return total;
}

/// The same where f(k, part) adds element k to the `part` of its chunk.
template <class Sum, class F>
Sum reduceInChunks(std::size_t count, F&& f) {
  return reduceChunks<Sum>(count, [&](std::size_t begin, std::size_t end, Sum& part) {
    for (std::size_t k = begin; k < end; ++k) f(k, part);
  });
}

/// Concatenates what f(begin, end, found) appends to `found` for each chunk of [0, count).
template <class Found = Index, class F>
std::vector<Found> gatherChunks(std::size_t count, F&& f, std::ptrdiff_t from = parallelFrom) {
  std::vector<std::vector<Found>> parts((count + chunkSize - 1) / chunkSize);
  forEachChunk(
      count,
      [&](std::size_t begin, std::size_t end) {
        std::vector<Found> found;  // one of its own: those in `parts` share cache lines
        f(begin, end, found);
        parts[begin / chunkSize] = std::move(found);
      },
      from);
  std::size_t size = 0;
  for (const auto& part : parts) size += part.size();
  std::vector<Found> all;
  all.reserve(size);
  for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

/// Those agentAt(k), k in [0, count), that are wanted(i), in their order.
template <class AgentAt, class Wanted>
std::vector<Index> agentsAmong(std::size_t count, const AgentAt& agentAt, const Wanted& wanted) {
  return gatherChunks(
      count,
      [&](std::size_t begin, std::size_t end, std::vector<Index>& found) {
        std::array<Index, chunkSize> kept;
        Index* next = kept.data();
        // Each is noted, and kept by counting it: no branch to be guessed wrong.
        for (std::size_t k = begin; k < end; ++k) {
          *next = agentAt(k);
          next += wanted(*next) ? 1 : 0;
        }
        found.assign(kept.data(), next);
      },
      parallelTestFrom);
}

/// The agents of [0, count) that are wanted(i), in ascending order.
template <class Wanted>
std::vector<Index> agentsThat(std::size_t count, const Wanted& wanted) {
  return agentsAmong(
      count, [](std::size_t k) { return static_cast<Index>(k); }, wanted);
}

/// Those of `agents` that are wanted(i), in their order.
template <class Wanted>
std::vector<Index> agentsOf(std::span<const Index> agents, const Wanted& wanted) {
  return agentsAmong(
      agents.size(), [agents](std::size_t k) { return agents[k]; }, wanted);
}

}  // namespace restenosis

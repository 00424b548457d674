#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "tissue/agents/AgentStore.h"
#include "tissue/agents/Capacity.h"
#include "tissue/agents/Chunks.h"

namespace restenosis {

/// A set of agents that several threads add to. To find its agents costs what the chunks cost that have any.
class MarkedAgents {
 public:
  /// Makes it a set of so many agents; those beyond the former number are not in it.
  void resize(std::size_t agents) {
    growCapacity(marks_, agents);
    marks_.resize(agents, 0);
    anyInChunk_.resize((agents + chunkSize - 1) / chunkSize, 0);
  }
  void mark(Index i) {
    std::atomic_ref(marks_[i]).store(1, std::memory_order_relaxed);
    std::atomic_ref(anyInChunk_[i / chunkSize]).store(1, std::memory_order_relaxed);
  }
  void markAll() {
    std::ranges::fill(marks_, 1);
    std::ranges::fill(anyInChunk_, 1);
  }
  /// Empties the set. Returns its agents, but those that are not wanted(i), in ascending order.
  template <class Wanted>
  std::vector<Index> extract(const Wanted& wanted) {
    std::vector<std::size_t> begins;
    for (std::size_t chunk = 0; chunk < anyInChunk_.size(); ++chunk)
      if (anyInChunk_[chunk]) begins.push_back(chunk * chunkSize);
    std::vector<Index> agents = agentsAmong(
        begins.size() * chunkSize,
        [&](std::size_t k) { return static_cast<Index>(begins[k / chunkSize] + k % chunkSize); },
        [&](Index i) { return i < marks_.size() && marks_[i] && wanted(i); });
    for (const std::size_t begin : begins) {
      const std::size_t end = std::min(marks_.size(), begin + chunkSize);
      std::fill(marks_.data() + begin, marks_.data() + end, 0);
      anyInChunk_[begin / chunkSize] = 0;
    }
    return agents;
  }

 private:
  std::vector<std::uint8_t> marks_;
  std::vector<std::uint8_t> anyInChunk_;  ///< whether any agent of a chunk may be marked
};

}  // namespace restenosis

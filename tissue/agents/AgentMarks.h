#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "tissue/agents/AgentStore.h"
#include "tissue/agents/Chunks.h"
#include "tissue/agents/Room.h"

namespace restenosis {

/// Marks of agents. To find those that are set takes as long as there are pieces of `chunkSize` agents with
/// any: little where few are set, or many that are near each other in the store.
class AgentMarks {
 public:
  /// Sets the mark of one of the agents; several threads may.
  void set(Index i) {
    std::atomic_ref(marks_[i]).store(1, std::memory_order_relaxed);
    std::atomic_ref(any_[i / chunkSize]).store(1, std::memory_order_relaxed);
  }
  void setAll() {
    std::ranges::fill(marks_, 1);
    std::ranges::fill(any_, 1);
  }
  /// Clears those that are set.
  void clear() {
    for (std::size_t piece = 0; piece < any_.size(); ++piece) {
      if (any_[piece] == 0) continue;
      std::fill(marks_.begin() + begin(piece), marks_.begin() + end(piece), 0);
      any_[piece] = 0;
    }
  }
  /// Makes it the marks of so many agents; those of new ones are set.
  void resize(std::size_t agents) {
    const std::size_t before = marks_.size();
    makeRoom(marks_, agents);
    marks_.resize(agents, 1);
    any_.resize((agents + chunkSize - 1) / chunkSize, 0);
    for (std::size_t i = before; i < agents; ++i) any_[i / chunkSize] = 1;
  }

  /// The agents that are marked and wanted(i), in ascending order.
  template <class Wanted>
  std::vector<Index> those(const Wanted& wanted) const {
    std::vector<std::size_t> pieces;
    for (std::size_t piece = 0; piece < any_.size(); ++piece)
      if (any_[piece] != 0) pieces.push_back(piece);
    return agentsAmong(
        pieces.size() * chunkSize,
        [&](std::size_t k) { return static_cast<Index>(begin(pieces[k / chunkSize]) + k % chunkSize); },
        [&](Index i) { return i < marks_.size() && marks_[i] != 0 && wanted(i); });
  }

 private:
  static std::size_t begin(std::size_t piece) { return piece * chunkSize; }
  std::size_t end(std::size_t piece) const { return std::min(marks_.size(), begin(piece + 1)); }

  std::vector<std::uint8_t> marks_;
  std::vector<std::uint8_t> any_;  ///< whether any agent of a piece may be marked
};

}  // namespace restenosis

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "tissue/agents/AgentStore.h"
#include "tissue/agents/Chunks.h"
#include "tissue/equilibrium/ActiveChunk.h"

namespace restenosis {

/// The agents that a relaxation moves, in the order in which they were added, chunk by chunk.
class ActiveSet {
 public:
  /// Makes it the empty set of so many agents. Gives memory back where it was large and became small.
  void reset(std::size_t agents);

  bool contains(Index i) const { return isActive_[i] != 0; }
  std::size_t size() const { return agents_.size(); }
  bool empty() const { return agents_.empty(); }
  std::span<const Index> agents() const { return agents_; }
  /// The place of agent i, which is active: agents()[place] == i.
  std::size_t placeOf(Index i) const { return place_[i]; }
  ActiveChunk& chunkOf(std::size_t place) { return chunks_[place / ActiveChunk::capacity]; }
  const ActiveChunk& chunkOf(std::size_t place) const { return chunks_[place / ActiveChunk::capacity]; }
  /// The place in its chunk.
  static std::size_t inChunk(std::size_t place) { return place % ActiveChunk::capacity; }
  std::span<ActiveChunk> chunks() { return chunks_; }

  /// Adds agents, none of them active. set(chunk, n, k) makes the n-th of a chunk the k-th of them; it is
  /// called by several threads.
  template <class Set>
  void add(std::span<const Index> added, const Set& set) {
    const std::size_t first = size();
    append(added);
    forEachInChunks(added.size(), [&](std::size_t k) { set(chunkOf(first + k), inChunk(first + k), k); });
    fillLastLanes();
  }
  /// Removes the agents with an entry of 0 in `keep`, by place.
  void keepOnly(std::span<const std::uint8_t> keep);

  /// Calls f(chunk, agents, first) for each chunk, its agents and the place of the first, in parallel.
  template <class F>
  void forEach(const F& f) {
    forEachChunk(size(),
                 [&](std::size_t begin, std::size_t end) { f(chunkOf(begin), slice(begin, end), begin); });
  }
  /// Lets f(chunk, agents, part) add each chunk to a Sum of its own, then joins these in order.
  template <class Sum, class F>
  Sum reduce(const F& f) const {
    return reduceChunks<Sum>(size(), [&](std::size_t begin, std::size_t end, Sum& part) {
      f(chunkOf(begin), slice(begin, end), part);
    });
  }
  /// Concatenates what f(chunk, agents, first, found) appends to `found`.
  template <class F>
  std::vector<Index> gather(const F& f) {
    return gatherChunks(size(), [&](std::size_t begin, std::size_t end, std::vector<Index>& found) {
      f(chunkOf(begin), slice(begin, end), begin, found);
    });
  }

 private:
  std::span<const Index> slice(std::size_t begin, std::size_t end) const {
    return agents().subspan(begin, end - begin);
  }
  void append(std::span<const Index> added);
  void resize(std::size_t count);
  void fillLastLanes();

  std::vector<Index> agents_;
  std::vector<ActiveChunk> chunks_;
  std::vector<std::uint8_t> isActive_;  ///< of all agents
  std::vector<Index> place_;            ///< of those that are active
};

}  // namespace restenosis

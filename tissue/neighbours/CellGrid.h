#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "tissue/agents/AgentStore.h"
#include "tissue/agents/Chunks.h"
#include "tissue/neighbours/CellLattice.h"

namespace restenosis {

/// Position of agent i [m]. Throws std::invalid_argument naming the agent when it is not finite.
Vec3 finitePosition(const AgentStore& agents, Index i);

/// Sorts agents into cubic cells of one size, each cell's agents in ascending order.
class CellGrid {
 public:
  /// `cellSize` > 0 [m]. Throws std::invalid_argument naming the agent when a position is not finite.
  CellGrid(const AgentStore& agents, double cellSize);
  /// Sorts `count` points instead, pointAt(k) the k-th of them, all finite; "agent" stands for k then.
  template <class PointAt>
  CellGrid(std::size_t count, const PointAt& pointAt, double cellSize) : lattice_(count, pointAt, cellSize) {
    std::vector<std::uint32_t> cell(count);
    forEachInChunks(count, [&](std::size_t k) { cell[k] = lattice_.cellOf(pointAt(k)); });
    sort(cell);
  }

  double cellSize() const { return lattice_.cellSize(); }
  std::size_t cellCount() const { return start_.size() - 1; }

  /// Calls f(j) once for each agent in a cell that the ball around `point` may touch, in no particular order.
  /// All agents within `distance` of `point` are among them; others too, so distances must be tested.
  template <class F>
  void forEachCandidate(const Vec3& point, double distance, F&& f) const {
    forEachCandidateRange(point, distance, [&](std::uint32_t begin, std::uint32_t end) {
      for (std::uint32_t n = begin; n < end; ++n) f(order_[n]);
    });
  }

  /// The same agents as ranges [begin, end) of places in order(), for data kept in that order.
  template <class F>
  void forEachCandidateRange(const Vec3& point, double distance, F&& f) const {
    lattice_.forEachRange(point, distance,
                          [&](std::int64_t begin, std::int64_t end) { f(start_[begin], start_[end]); });
  }

  /// All agents, cell by cell.
  std::span<const Index> order() const { return order_; }

 private:
  /// By the cells of the agents.
  void sort(std::span<const std::uint32_t> cell);

  CellLattice lattice_;
  std::vector<std::uint32_t> start_;  ///< first entry of each cell in order_, and the end
  std::vector<Index> order_;
};

}  // namespace restenosis

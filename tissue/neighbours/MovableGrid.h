#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "tissue/agents/Chunks.h"
#include "tissue/agents/RowPool.h"
#include "tissue/neighbours/CellLattice.h"
#include "tissue/neighbours/PackedPlace.h"

namespace restenosis {

/// Points in cubic cells of one size, for few points that move among many that stay: a move costs the same
/// however many points there are. CellGrid is quicker to make.
class MovableGrid {
 public:
  /// `count` points, pointAt(k) the k-th of them, all finite; `cellSize` > 0 [m].
  template <class PointAt>
  MovableGrid(std::size_t count, const PointAt& pointAt, double cellSize)
      : lattice_(count, pointAt, cellSize), cell_(count) {
    forEachInChunks(count, [&](std::size_t k) { cell_[k] = lattice_.cellOf(pointAt(k)); });
    fill();
    forEachInChunks(count,
                    [&](std::size_t k) { entryOf(static_cast<Index>(k)).place = placeOf(pointAt(k)); });
  }

  Index size() const { return static_cast<Index>(cell_.size()); }
  /// Puts these points, in ascending order, where pointAt(i) is; those from size() on, without a gap, are
  /// added.
  template <class PointAt>
  void place(std::span<const Index> points, const PointAt& pointAt) {
    // Most stay in their cells: only the others are left to one thread.
    const auto look = [&](std::size_t begin, std::size_t end, std::vector<Move>& moves) {
      for (const Index i : points.subspan(begin, end - begin)) {
        const Vec3& point = pointAt(i);
        const Move move{.entry = {.place = placeOf(point), .point = i}, .cell = lattice_.cellOf(point)};
        if (i < size() && cell_[i] == move.cell) {
          entryOf(i).place = move.entry.place;  // names are read by other threads
        } else {
          moves.push_back(move);
        }
      }
    };
    for (const Move& move : gatherPieces<Move>(points.size(), look)) take(move);
  }

  /// Calls f(j) once for each point within `distance` of `point`, in no particular order. Others may be among
  /// them, so distances must be tested.
  template <class F>
  void forEachCandidate(const Vec3& point, double distance, F&& f) const {
    const CellLattice::InCell here = lattice_.inCell(point);
    const auto reach = static_cast<float>(
        roundedReach * (distance / lattice_.cellSize() * CellLattice::InCell::most + PackedPlace::error));
    lattice_.forEachRow(
        point, distance, [&](std::int64_t begin, std::int64_t end, const CellLattice::Offset& offset) {
          const float limit = offset.known ? reach * reach : std::numeric_limits<float>::infinity();
          PackedPlace::From from(here, offset);
          for (std::int64_t cell = begin; cell < end; ++cell, from.nextCell()) {
            for (const Entry& entry : buckets_[static_cast<std::size_t>(cell)]) {
              if (from.squaredDistance(entry.place) <= limit || !entry.place.known()) f(entry.point);
            }
          }
        });
  }

  /// Brings into the cache what the same search reads: first readRoomsAhead(), then readAhead(). Speed only.
  void readRoomsAhead(const Vec3& point, double distance) const {
    lattice_.forEachRow(point, distance, [&](std::int64_t begin, std::int64_t, const auto&) {
      buckets_.readRoomAhead(static_cast<std::size_t>(begin));
    });
  }
  void readAhead(const Vec3& point, double distance) const {
    lattice_.forEachRow(point, distance, [&](std::int64_t begin, std::int64_t end, const auto&) {
      for (std::int64_t cell = begin; cell < end; ++cell) buckets_.readAhead(static_cast<std::size_t>(cell));
    });
  }

 private:
  /// A point, and where it is, so that a search need not look that up for the many that are too far.
  struct Entry {
    PackedPlace place;
    Index point;
  };
  /// A point that comes into a cell.
  struct Move {
    Entry entry;
    std::uint32_t cell;
  };
  // Of a distance: by more than it is rounded.
  static constexpr double roundedReach = 1 + 1e-6;

  /// Puts every point into the bucket of its cell.
  void fill();
  PackedPlace placeOf(const Vec3& point) const { return PackedPlace(lattice_.inCell(point)); }
  Entry& entryOf(Index i) { return *std::ranges::find(buckets_[cell_[i]], i, &Entry::point); }
  void take(const Move& move);

  CellLattice lattice_;
  std::vector<std::uint32_t> cell_;  ///< of each point
  RowPool<Entry> buckets_;           ///< the points of each cell
};

}  // namespace restenosis

#pragma once

#include <algorithm>
#include <cstdint>

#include "tissue/neighbours/CellLattice.h"

namespace restenosis {

/// Where in its cell of a CellLattice a point is, in four bytes: to a thousandth of the cell, which is enough
/// to leave out most of those that a search does not want.
class PackedPlace {
 public:
  PackedPlace() = default;
  explicit PackedPlace(const CellLattice::InCell& in)
      : bits_(in.known ? part(in.place.x()) | part(in.place.y()) << width | part(in.place.z()) << 2 * width
                       : unknown) {}

  /// Seen from a point: how far, at least, are those in a cell at this offset from its own?
  class From {
   public:
    From(const CellLattice::InCell& seen, const CellLattice::Offset& offset)
        : x_(fromCentre(offset.x, seen.place.x())),
          y_(fromCentre(offset.y, seen.place.y())),
          z_(fromCentre(offset.z, seen.place.z())) {}
    /// One cell on along x.
    void nextCell() { x_ += CellLattice::InCell::most; }
    /// Square of the distance to a place, if that is known [thousandths of a cell, squared].
    float squaredDistance(PackedPlace to) const {
      const float x = x_ + to.part(0), y = y_ + to.part(1), z = z_ + to.part(2);
      return x * x + y * y + z * z;
    }

   private:
    static float fromCentre(int offset, double seen) {
      return CellLattice::InCell::most * static_cast<float>(offset) + 0.5F - static_cast<float>(seen);
    }
    float x_, y_, z_;
  };
  bool known() const { return bits_ != unknown; }
  /// By how much squaredDistance's root errs at most.
  static constexpr double error = 1;

 private:
  static constexpr int width = 10;
  static constexpr std::uint32_t largest = (1U << width) - 1, unknown = UINT32_MAX;
  static std::uint32_t part(double place) { return std::min(largest, static_cast<std::uint32_t>(place)); }
  float part(int axis) const { return static_cast<float>(bits_ >> axis * width & largest); }

  std::uint32_t bits_ = unknown;
};

}  // namespace restenosis

#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "tissue/biology/ContactInhibitionLaw.h"

namespace restenosis {

/// The share of directions around a cell's centre that no neighbour covers (model 6).
///
/// A neighbour of radius R at distance D <= `exposureRange` (R1 + R2) covers the directions within the angle
/// asin(k R / D) of its own: the shadow of a sphere of k times its radius, k = `cellCover`. Laminae are
/// sheets: they cover what lies behind them, not what lies beside them. Seen at an angle t to its normal (the
/// vessel's radius), a lamina agent has k = cellCover + (laminaCover - cellCover) cos^2 t, so that a gap in
/// the sheet is open to the lumen although the sheet continues around it. Where k R reaches D the shadow is
/// the half space, so that overlap never covers what lies on the far side. A neighbour at the very centre has
/// no direction and covers none. Directions are the `directions` points of a Fibonacci lattice on the sphere,
/// each standing for the same solid angle.
class ExposureMeasure {
 public:
  explicit ExposureMeasure(const ContactInhibitionParameters& parameters);

  double range() const { return range_; }
  /// Share of free directions, 0 to 1.
  double share(double radius, std::span<const ContactNeighbour> neighbours) const;
  /// Whether the share exceeds the threshold; as share(), but faster.
  bool exposed(double radius, std::span<const ContactNeighbour> neighbours) const;

 private:
  std::int64_t freeDirections(double radius, std::span<const ContactNeighbour> neighbours,
                              std::int64_t enough) const;

  std::vector<double> x_, y_, z_;  ///< unit vectors
  double range_, cellCover_, laminaCover_;
  std::int64_t largestInhibited_;  ///< with this many free directions or fewer a cell is not exposed
};

}  // namespace restenosis

#pragma once

#include <optional>
#include <span>

#include "bridge/surface/BandField.h"
#include "tissue/stent/Stent.h"

namespace restenosis {

/// The distance to struts on the nodes of a grid, kept for the next time, when the grid is mostly the same:
/// struts stand still while tissue grows.
class StrutBand {
 public:
  /// The segments must outlive this, and stay as they are.
  explicit StrutBand(std::span<const StrutSegment> segments) : segments_(segments) {}
  /// Their distance [m], clipped at `clip`; null without segments.
  const BandField* on(const LumenGrid& grid, double clip);

 private:
  std::span<const StrutSegment> segments_;
  std::optional<BandField> band_;
  double clip_ = 0;
};

}  // namespace restenosis

#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "bridge/surface/TriSurface.h"

namespace restenosis {

/// The narrowest place of a lumen. Its width is four times the area of the cross-section over its perimeter:
/// the diameter of a circle, twice the gap of a slit or an annulus.
struct NarrowestPlace {
  double width;                     ///< [m]; 0 where the lumen is closed
  std::optional<double> fromInlet;  ///< in a lumen that lies along z [m]
};

/// Looks at planes of constant z about `spacing` [m] apart. Of a lumen that does not lie along z, whose axis
/// is not known, only the ends are looked at. The lumen must pass requireLumenWithPlanarEnds.
NarrowestPlace narrowestPlace(const TriSurface& lumen, double spacing);

/// What a backend resolves the wall with.
struct WallPieces {
  double size;                  ///< of a cell at the wall, or between two nodes [m]
  std::string_view name;        ///< "cells at the wall", "spacings"
  double leastAcross;           ///< below which the flow is remarked on
  std::string_view resolvedBy;  ///< the settings to change
};

/// What is to be said of a lumen that has less than `leastAcross` pieces across its narrowest place; empty
/// where there is nothing.
std::string narrownessRemark(const TriSurface& lumen, const WallPieces& pieces);

}  // namespace restenosis

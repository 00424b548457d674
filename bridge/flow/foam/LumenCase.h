#pragma once

#include <array>
#include <vector>

#include "bridge/flow/FlowBackend.h"
#include "bridge/flow/LumenShape.h"
#include "bridge/flow/foam/BackgroundBlock.h"
#include "bridge/flow/foam/DictionaryText.h"
#include "bridge/flow/foam/FoamSettings.h"
#include "bridge/flow/foam/InletProfile.h"

namespace restenosis {

/// Which ends the mesher cuts in planes of constant z; the others are caps of its surface.
enum class LumenEnds {
  cut,       ///< both: the lumen lies along z, and nothing else comes near their planes
  inletCut,  ///< the inlet: the lumen begins along z, and nothing else lies below or near its plane
  caps       ///< neither
};

/// The lumen as the OpenFOAM case needs it, in SI units.
struct LumenCase {
  EndPlane inlet, outlet;
  std::vector<EndPlane> furtherOutlets;  ///< beside the first
  InletProfile profile;
  LumenEnds ends = LumenEnds::cut;
  Vec3 low, high;  ///< bounding box
  BackgroundBlock block;
  std::array<Vec3, 2> inside;  ///< where the lumen is, for the first and the second attempt [m]
  double volume = 0.0;         ///< enclosed by the surface [m^3]
  double wallArea = 0.0, strutArea = 0.0;
  bool hasStruts() const { return strutArea > 0.0; }
  /// From end to end [m]; where they are not both cut, its volume over the mean area of its ends.
  double length() const;
};

/// Measures a lumen. Throws std::invalid_argument where the surface cannot be meshed (see
/// requireLumenWithPlanarEnds), or where its size does not go with the cell sizes: less than two cells across
/// the inlet or too many in all, as after a mistaken unit.
LumenCase measureLumen(const TriSurface& lumen, const FoamSettings& settings);

/// How hard the mesher and the solver try.
enum class Effort { normal, robust };

/// Writes the case's numbers into its dictionary (system/lumenParameters), in SI units.
void writeLumenParameters(DictionaryText& parameters, const LumenCase& lumen,
                          const FlowConditions& conditions, const FoamSettings& settings, Effort effort,
                          int ranks);

}  // namespace restenosis

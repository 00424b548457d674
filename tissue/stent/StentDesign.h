#pragma once

#include <string_view>
#include <vector>

#include "tissue/parameters/ParameterProblem.h"
#include "tissue/stent/StentParameters.h"
#include "tissue/stent/StrutChain.h"
#include "tissue/vessel/VesselParameters.h"

namespace restenosis {

/// A layout of struts on a cylinder.
struct StentDesign {
  std::string_view name;  ///< in a scene
  bool spansLength;       ///< whether it reads StentParameters::length
  std::vector<StrutSegment> (*build)(const StentParameters&, const StentLayout&);
  /// Parameters that do not fit each other or the vessel. Does not check that a stent that spans its length
  /// fits into the vessel (validate()).
  std::vector<ParameterProblem> (*check)(const StentParameters&, const VesselParameters&);
};

/// The names of all designs, for ParameterVisitor::choice.
std::vector<std::string_view> stentDesignNames();
/// Throws std::invalid_argument, with the valid names, for an unknown one.
const StentDesign& stentDesign(std::string_view name);

/// One ring halfway along the vessel.
std::vector<StrutSegment> buildRing(const StentParameters&, const StentLayout&);
std::vector<ParameterProblem> checkRing(const StentParameters&, const VesselParameters&);
/// `ringCount` rings evenly over the stent's length.
std::vector<StrutSegment> buildRings(const StentParameters&, const StentLayout&);
std::vector<ParameterProblem> checkRings(const StentParameters&, const VesselParameters&);
/// The same, neighbours joined by `linkCount` straight links, staggered from gap to gap.
std::vector<StrutSegment> buildRingsWithLinks(const StentParameters&, const StentLayout&);
/// A helix of `helixTurns` turns over the stent's length.
std::vector<StrutSegment> buildHelix(const StentParameters&, const StentLayout&);
std::vector<ParameterProblem> checkHelix(const StentParameters&, const VesselParameters&);
/// After the BiodivYsio (T6, simplified): sinusoidal rings, neighbours mirrored so that crest faces crest,
/// `linkCount` of the facing crests joined by straight links.
std::vector<StrutSegment> buildBiodivysio(const StentParameters&, const StentLayout&);
std::vector<ParameterProblem> checkBiodivysio(const StentParameters&, const VesselParameters&);

/// For designs with rings: the problem if `ringCount` rings, each of this extent along the vessel [m],
/// overlap in the stent's length.
std::vector<ParameterProblem> checkRingsOf(double extent, const StentParameters&);

}  // namespace restenosis

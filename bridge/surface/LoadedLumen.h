#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bridge/surface/LumenCap.h"
#include "bridge/surface/TriSurface.h"
#include "tissue/vessel/VesselParameters.h"

namespace restenosis {

/// Reads a lumen that a user has brought as a surface file (SurfaceFile.h), in units of `metresPerUnit` [m],
/// and makes it a surface that flow can be solved in: closed, normals outwards, planar ends with the regions
/// inlet and outlet (docs/model/lumen.md).
///
/// Nothing need be named. Ends are planar caps whose whole rim is a sharp convex edge, or open planar rims,
/// which are capped; there must be two. Solids may say by their names what they are
/// (`meaningsOf`). Without such names the inlet is the end with the lower coordinate along the axis (x, y or
/// z) on which the ends' centres differ most.
///
/// Where there may be several outlets, and more than one solid is named so, each is one, in the order of
/// their names; then the inlet must be named too, and nothing may be open.
///
/// Throws std::runtime_error, saying what is wrong and what was found instead, where the file cannot be read
/// or is no such lumen.
TriSurface loadLumen(const std::filesystem::path& file, double metresPerUnit, Outlets outlets = Outlets::one);

/// The same for the surface that a vessel names, in the unit that it names.
TriSurface loadLumen(const VesselParameters& vessel, Outlets outlets = Outlets::one);

/// A lumen with what is to be told of it.
struct DescribedLumen {
  TriSurface surface;
  std::vector<std::string> parts;    ///< inlet, outlet, wall and strut, a line each (`lumenParts`)
  std::vector<std::string> remarks;  ///< what may be a mistake
  std::vector<std::string> outlets;  ///< names of several outlets, in their order; none of one
};

/// As loadLumen.
DescribedLumen loadDescribedLumen(const std::filesystem::path& file, double metresPerUnit,
                                  Outlets outlets = Outlets::one);
DescribedLumen loadDescribedLumen(const VesselParameters& vessel, Outlets outlets = Outlets::one);

/// Diameter of the circle with the area of this end [m].
double endDiameter(const TriSurface& lumen, SurfaceRegion end);

}  // namespace restenosis

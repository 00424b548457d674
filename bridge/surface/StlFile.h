#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bridge/surface/TriSurface.h"

namespace restenosis {

/// Writes the triangles of some regions (all if empty) as binary STL, in units of `metresPerUnit` (1e-3: mm).
/// Throws WriteFailed.
void writeStl(const std::filesystem::path& file, const TriSurface& surface, double metresPerUnit,
              std::span<const SurfaceRegion> regions = {});

/// Writes all regions as named solids (wall, strut, inlet, outlet) of one ASCII STL; absent regions are left
/// out.
void writeNamedStl(const std::filesystem::path& file, const TriSurface& surface, double metresPerUnit);

/// Reads an STL file, binary or ASCII, and merges equal vertices. All triangles become `wall`: see
/// `markEnds`. Throws std::runtime_error like `readStlTriangles`.
TriSurface readStl(const std::filesystem::path& file, double metresPerUnit);

/// Triangles as a file has them, and the solid that each belongs to.
struct SurfaceSolids {
  TriSurface surface;                ///< every region is `wall`
  std::vector<std::uint32_t> solid;  ///< one a triangle
  std::vector<std::string> names;    ///< by solid; empty texts where the file names none, as binary ones do
};

/// Reads a surface file (SurfaceFile.h) with its solids. Vertices closer than 1e-6 of the surface's extent
/// (assumed: what seven digits leave) become one, and triangles that vanish by it are left out. Throws
/// std::runtime_error like `readSurfaceTriangles`, where a vertex is 1000 times as far from the middle as
/// half of the others (assumed), where single precision rounds the largest coordinate by more than 0.001 of
/// the surface's width (assumed), and where no triangle is left.
SurfaceSolids readSurfaceSolids(const std::filesystem::path& file, double metresPerUnit);

/// Makes the triangles that lie in the planes z = 0 and z = `length` [m] inlet and outlet, and puts them
/// exactly there; `tolerance` [m] is how far a vertex may be off.
void markEnds(TriSurface& surface, double length, double tolerance);

std::string_view regionName(SurfaceRegion region);
/// Those that a surface may have: wall, strut, inlet and each of its outlets.
std::vector<SurfaceRegion> allRegions(const TriSurface& surface);

}  // namespace restenosis

#pragma once

#include <filesystem>
#include <string_view>

#include "bridge/surface/FileTriangles.h"

namespace restenosis {

/// Endings of the names of surface files, in lower case.
inline constexpr std::string_view surfaceFileEndings[] = {".stl", ".vtp", ".ply", ".obj"};

/// Whether a file is a surface by its name's ending, in letters of any case.
bool isSurfaceFile(const std::filesystem::path& file);

/// The triangles of a surface file, in its own unit: VTK's XML polygonal data, PLY or OBJ by its name's
/// ending, and STL otherwise (StlTriangles.h). Polygons and strips are divided into triangles.
///
/// Solids: a VTP has those of its cell array `region`, be it texts or the numbers 0 to 3 for wall, strut,
/// inlet and outlet, as in the lumens that a run writes. PLY and OBJ are one solid without a name.
///
/// Throws std::runtime_error, which names the file, where it is missing, too large, not of its kind, without
/// triangles, or where a face names no vertex, a vertex is not finite or a region is none of these.
FileTriangles readSurfaceTriangles(const std::filesystem::path& file);

}  // namespace restenosis

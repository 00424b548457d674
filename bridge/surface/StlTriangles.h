#pragma once

#include <filesystem>

#include "bridge/surface/FileTriangles.h"

namespace restenosis {

/// Reads an STL file, binary or ASCII, with all of its solids: files of either kind may be joined, also where
/// the first is binary. A binary solid may begin with "solid" too: what is ASCII has no control characters
/// where a binary one has its header and its count of triangles. The name in a binary header is not read: it
/// is free text, mostly of the program that wrote it. Fewer than 50 bytes behind the triangles of a binary
/// solid are no triangle and left alone. ASCII: see `parseStlText`.
///
/// Throws std::runtime_error, which names the file and, where it is ASCII, the line, if it is missing, cut
/// off, no STL, or without triangles, where it has 50 bytes or more behind a solid that are no further one,
/// so too where a header announces none of the triangles that follow it, and where a vertex is not finite.
FileTriangles readStlTriangles(const std::filesystem::path& file);

}  // namespace restenosis

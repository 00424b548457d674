#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace restenosis {

/// The triangles of an STL file as it has them, in its own unit: in single precision where it is binary.
struct StlTriangles {
  std::vector<std::array<double, 9>> corners;  ///< x, y, z of each of three corners
  std::vector<std::uint32_t> solid;            ///< one a triangle
  std::vector<std::string> names;              ///< by solid; empty texts where the file names none
};

/// Reads an STL file, binary or ASCII. A binary file may begin with "solid" too: what is ASCII has no control
/// characters where a binary file has its header and its count of triangles. Bytes after the triangles that a
/// binary file announces are left alone. ASCII: see `parseStlText`.
///
/// Throws std::runtime_error, which names the file and, where it is ASCII, the line, if it is missing, cut
/// off, no STL, or without triangles, and where a vertex is not finite.
StlTriangles readStlTriangles(const std::filesystem::path& file);

}  // namespace restenosis

#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace restenosis {

/// The triangles of a surface file as it has them, in its own unit and often in single precision.
struct FileTriangles {
  std::vector<std::array<double, 9>> corners;  ///< x, y, z of each of three corners
  std::vector<std::uint32_t> solid;            ///< one a triangle
  std::vector<std::string> names;              ///< by solid; empty texts where the file names none

  template <class Archive>
  void archive(Archive& a) {
    a(corners, solid, names);
  }
};

/// Throws std::runtime_error: the file, and what is wrong with it.
[[noreturn]] inline void refuseFile(const std::filesystem::path& file, std::string_view what) {
  throw std::runtime_error(file.string() + " " + std::string(what));
}

}  // namespace restenosis

#include "StlTriangles.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <stdexcept>
#include <string_view>

#include "FileContent.h"
#include "StlText.h"

namespace restenosis {
namespace {

constexpr std::size_t headerSize = 84;        ///< 80 bytes of anything, and the count of triangles
constexpr std::size_t bytesOfATriangle = 50;  ///< normal, three vertices, and two bytes of anything
constexpr std::size_t bytesOfANormal = 12;

[[noreturn]] void refuse(const std::filesystem::path& file, std::string_view what) {
  throw std::runtime_error(fmt::format("{} {}", file.string(), what));
}

bool isText(std::string_view content) {
  const std::string_view head = content.substr(0, headerSize);
  return std::none_of(head.begin(), head.end(),
                      [](unsigned char c) { return c < ' ' && (c < '\t' || c > '\r'); });
}

StlTriangles parseBinary(std::string_view content, const std::filesystem::path& file) {
  if (content.size() < headerSize)
    refuse(file, fmt::format("is cut off, or is no STL file: it has {} bytes, the header of a binary one {}",
                             content.size(), headerSize));
  std::uint32_t count = 0;
  std::memcpy(&count, content.data() + headerSize - sizeof(count), sizeof(count));
  const std::size_t room = (content.size() - headerSize) / bytesOfATriangle;
  if (count > room)
    refuse(file, fmt::format("is cut off, or is no STL file: its header announces {} triangles, it has room "
                             "for {}",
                             count, room));
  StlTriangles result;
  result.names.emplace_back();
  result.solid.assign(count, 0);
  result.corners.resize(count);
  const char* next = content.data() + headerSize + bytesOfANormal;
  for (std::size_t t = 0; t < count; ++t, next += bytesOfATriangle) {
    std::array<float, 9> corners{};
    std::memcpy(corners.data(), next, sizeof(corners));
    std::copy(corners.begin(), corners.end(), result.corners[t].begin());
    if (!std::all_of(corners.begin(), corners.end(), [](float x) { return std::isfinite(x); }))
      refuse(file,
             fmt::format("has a vertex that is not a finite number, in triangle {} of {}", t + 1, count));
  }
  return result;
}

}  // namespace

StlTriangles readStlTriangles(const std::filesystem::path& file) {
  if (!std::filesystem::is_regular_file(file)) refuse(file, "is not a file");
  const std::string content = contentOf(file);
  if (content.empty()) refuse(file, "is empty: it must be an STL file");
  StlTriangles result = isText(content) ? parseStlText(content, file.string()) : parseBinary(content, file);
  if (result.corners.empty()) refuse(file, "holds no triangles");
  return result;
}

}  // namespace restenosis

#include "bridge/surface/StlTriangles.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>
#include <iterator>
#include <stdexcept>
#include <string_view>

#include "bridge/surface/StlText.h"
#include "bridge/system/FileContent.h"
#include "tissue/parameters/Trimmed.h"

namespace restenosis {
namespace {

constexpr std::size_t headerSize = 84;        ///< 80 bytes of anything, and the count of triangles
constexpr std::size_t bytesOfATriangle = 50;  ///< normal, three vertices, and two bytes of anything
constexpr std::size_t bytesOfANormal = 12;

/// Ten million triangles of a binary file [bytes], assumed: far more than are meshed here.
constexpr std::uintmax_t largestStlFile = 512 << 20;

/// What may stand behind the last solid: blanks, ends of lines, and what old systems fill or end files with.
bool isPadding(std::string_view content) {
  return content.find_first_not_of(std::string_view(" \t\v\f\r\n\0\x1A", 8)) == std::string_view::npos;
}

/// Of the triangles that the header of a binary file announces. The file has the header.
std::size_t announced(std::string_view content) {
  std::uint32_t count = 0;
  std::memcpy(&count, content.data() + headerSize - sizeof(count), sizeof(count));
  return count;
}

std::size_t roomIn(std::string_view content) { return (content.size() - headerSize) / bytesOfATriangle; }

/// Whether a text begins as a solid in ASCII does, blank lines aside.
bool beginsWithSolid(std::string_view text) {
  constexpr std::string_view word = "solid";
  text = trimmed(text, " \t\v\f\r\n").substr(0, word.size());
  return std::ranges::equal(text, word, {}, [](unsigned char c) { return std::tolower(c); });
}

/// Whether a header holds a text, and nothing else but what fills it up.
bool headerIsText(std::string_view content) {
  const std::string_view head = content.substr(0, headerSize - sizeof(std::uint32_t));
  const auto end = head.find_last_not_of(std::string_view(" \0", 2));
  return end != std::string_view::npos && beginsAsStlText(head.substr(0, end + 1));
}

/// Whether the rest of a file, from the end of a solid on, is further solids or too short to be one. Headers
/// alone are looked at: by chance their counts do not lead to the very end of the file. Of what might be one
/// without triangles the text is looked at, too: triangles of which no header knows have many zeros.
bool isFurtherSolids(std::string_view rest) {
  while (rest.size() >= bytesOfATriangle) {
    if (beginsAsStlText(rest)) return beginsWithSolid(rest);
    if (rest.size() < headerSize) return false;
    const std::size_t count = announced(rest);
    if (count > roomIn(rest) || (count == 0 && !headerIsText(rest))) return false;
    rest.remove_prefix(headerSize + bytesOfATriangle * count);
  }
  return true;
}

/// Takes a binary solid off the front of what is left of the file.
void takeBinary(std::string_view& rest, const std::filesystem::path& file, FileTriangles& result) {
  if (rest.size() < headerSize)
    refuseFile(file,
               fmt::format("is cut off, or is no STL file: it has {} bytes, the header of a binary one {}",
                           rest.size(), headerSize));
  const std::size_t count = announced(rest), room = roomIn(rest), before = result.corners.size();
  if (count > room)
    refuseFile(file,
               fmt::format("is cut off, or is no STL file: its header announces {} triangles, it has room "
                           "for {}",
                           count, room));
  const std::string_view behind = rest.substr(headerSize + bytesOfATriangle * count);
  const bool more = behind.size() >= bytesOfATriangle, further = isFurtherSolids(behind);
  if (more && count == 0 && !(further && headerIsText(rest)))
    refuseFile(file,
               fmt::format("has a header that announces 0 triangles, but room for {}: what wrote it has not "
                           "filled in their number. Export it again",
                           room));
  if (more && !further)
    refuseFile(
        file,
        fmt::format(
            "holds more than it announces: its header announces {} triangles, it has room for {}, and the "
            "{} bytes behind the announced ones are not whole further solids. Export it again",
            before + count, before + room, behind.size()));
  const auto solid = static_cast<std::uint32_t>(result.names.size());
  result.names.emplace_back();
  const char* next = rest.data() + headerSize + bytesOfANormal;
  for (std::size_t t = 0; t < count; ++t, next += bytesOfATriangle) {
    std::array<float, 9> corners{};
    std::memcpy(corners.data(), next, sizeof(corners));
    if (!std::all_of(corners.begin(), corners.end(), [](float x) { return std::isfinite(x); }))
      refuseFile(file, fmt::format("has a vertex that is not a finite number, in triangle {} of {}",
                                   before + t + 1, before + count));
    std::copy(corners.begin(), corners.end(), result.corners.emplace_back().begin());
    result.solid.push_back(solid);
  }
  rest = behind;
}

/// Takes solids in ASCII off the front of what is left of the file.
void takeText(std::string_view& rest, std::size_t at, const std::filesystem::path& file,
              FileTriangles& result) {
  const std::string name =
      at == 0 ? file.string() : fmt::format("{}, text from byte {} on", file.string(), at + 1);
  takeStlText(rest, name, isFurtherSolids, result);
  if (isPadding(rest) && rest.size() < bytesOfATriangle) rest = {};
  if (rest.empty() || (rest.size() >= headerSize && isFurtherSolids(rest))) return;
  refuseFile(file,
             fmt::format("holds more than solids: {} triangles end with the text, and the {} bytes behind "
                         "it, room for {} more, are not whole further solids. Export it again",
                         result.corners.size(), rest.size(), rest.size() / bytesOfATriangle));
}

}  // namespace

FileTriangles readStlTriangles(const std::filesystem::path& file) {
  const std::string content = contentOf(file, largestStlFile);
  if (content.empty()) refuseFile(file, "is empty: it must be an STL file");
  FileTriangles result;
  for (std::string_view rest = content; !rest.empty();) {
    const bool first = rest.size() == content.size();
    if (!first && rest.size() < bytesOfATriangle) break;
    if (beginsAsStlText(rest)) {
      takeText(rest, content.size() - rest.size(), file, result);
    } else {
      takeBinary(rest, file, result);
    }
  }
  if (result.corners.empty()) refuseFile(file, "holds no triangles");
  return result;
}

}  // namespace restenosis

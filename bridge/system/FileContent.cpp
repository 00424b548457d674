#include "FileContent.h"

#include <fmt/format.h>

#include <fstream>
#include <stdexcept>

namespace restenosis {

std::string contentOf(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string content;
  char piece[1 << 16];
  while (stream.read(piece, sizeof piece) || stream.gcount() > 0)
    content.append(piece, static_cast<std::size_t>(stream.gcount()));
  // At the end of a file that was read whole only eof and fail are set
  if (!stream.eof() || stream.bad())
    throw std::runtime_error(fmt::format("{} cannot be read", file.string()));
  return content;
}

}  // namespace restenosis

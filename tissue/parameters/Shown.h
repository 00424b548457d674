#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "tissue/parameters/Printable.h"

namespace restenosis {

/// A text of a file for messages: in quotes, shortened, and printable().
inline std::string shown(std::string_view text) {
  constexpr std::size_t longest = 40;  // bytes, up to the end of the last character
  std::size_t end = 0;
  while (end < text.size() && end < longest) end += std::max<std::size_t>(1, characterSize(text.substr(end)));
  return fmt::format("'{}{}'", printable(text.substr(0, end)), end < text.size() ? "..." : "");
}

}  // namespace restenosis

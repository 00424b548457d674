#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "tissue/parameters/Printable.h"

namespace restenosis {

/// What a file has, fit to be shown in a message: in quotes, shortened, and without what a terminal would
/// obey.
inline std::string shown(std::string_view text) {
  constexpr std::size_t longest = 40;  // bytes, but for what is left of the last character
  std::size_t end = 0;
  while (end < text.size() && end < longest) end += std::max<std::size_t>(1, characterSize(text.substr(end)));
  return fmt::format("'{}{}'", printable(text.substr(0, end)), end < text.size() ? "..." : "");
}

}  // namespace restenosis

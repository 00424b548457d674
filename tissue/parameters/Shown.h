#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>

namespace restenosis {

/// What a file has, fit to be shown in a message: in quotes, shortened, and without what a terminal would
/// obey.
inline std::string shown(std::string_view text) {
  constexpr std::size_t longest = 40;
  std::string result(text.substr(0, longest));
  std::replace_if(
      result.begin(), result.end(), [](unsigned char c) { return c < ' ' || c > '~'; }, '?');
  return fmt::format("'{}{}'", result, text.size() > longest ? "..." : "");
}

}  // namespace restenosis

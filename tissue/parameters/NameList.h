#pragma once

#include <span>
#include <string>
#include <string_view>

namespace restenosis {

/// "a, b, c", for messages that say what is allowed. Not {fmt}'s join: for string views GCC 12 at -O3 warns
/// of a write past the end of the constant format, which is none.
inline std::string commaSeparated(std::span<const std::string_view> names) {
  std::string list;
  for (const auto name : names) list.append(list.empty() ? "" : ", ").append(name);
  return list;
}

}  // namespace restenosis

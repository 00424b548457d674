#pragma once

#include <span>
#include <string>
#include <string_view>

namespace restenosis {

/// "a, b, c", for messages that say what is allowed. By hand, because GCC 12 at -O3 warns of {fmt}'s join of
/// string views: it takes its parsing of a constant format for a write past its end.
inline std::string commaSeparated(std::span<const std::string_view> names) {
  std::string list;
  for (const auto name : names) list.append(list.empty() ? "" : ", ").append(name);
  return list;
}

}  // namespace restenosis

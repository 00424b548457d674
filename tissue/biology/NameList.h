#pragma once

#include <span>
#include <string>
#include <string_view>

namespace restenosis {

/// "a, b, c", for messages that say what is allowed.
inline std::string commaSeparated(std::span<const std::string_view> names) {
  std::string list;
  for (const auto name : names) {
    if (!list.empty()) list += ", ";
    list += name;
  }
  return list;
}

}  // namespace restenosis

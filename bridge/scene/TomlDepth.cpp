#include "bridge/scene/TomlDepth.h"

#include <algorithm>

namespace restenosis {
namespace {

/// Where the text in quotes ends that begins at `at`: behind its last quote, or where its line ends unclosed.
std::size_t endOfQuoted(std::string_view toml, std::size_t at) {
  const char quote = toml[at];
  const bool basic = quote == '"';
  const bool longText = toml.size() - at >= 3 && toml[at + 1] == quote && toml[at + 2] == quote;
  for (std::size_t i = at + (longText ? 3 : 1); i < toml.size(); ++i) {
    if (basic && toml[i] == '\\') {
      ++i;
    } else if (!longText && (toml[i] == quote || toml[i] == '\n')) {
      return toml[i] == quote ? i + 1 : i;
    } else if (longText && toml.substr(i, 3) == std::string_view(toml).substr(at, 3)) {
      // Up to two quotes may stand before those that close it
      return std::min(toml.find_first_not_of(quote, i), toml.size());
    }
  }
  return toml.size();
}

}  // namespace

int lineOfDeepName(std::string_view toml) {
  int line = 1, parts = 1;
  for (std::size_t i = 0; i < toml.size();) {
    const char c = toml[i];
    if (c == '"' || c == '\'') {
      const std::size_t end = endOfQuoted(toml, i);
      line += static_cast<int>(std::count(toml.begin() + static_cast<std::ptrdiff_t>(i),
                                          toml.begin() + static_cast<std::ptrdiff_t>(end), '\n'));
      i = end;
      continue;
    }
    if (c == '#') {
      i = std::min(toml.find('\n', i), toml.size());
      continue;
    }
    if (c == '.') {
      if (++parts > mostNameParts) return line;
    } else if (std::string_view("\n[]{},=").find(c) != std::string_view::npos) {
      parts = 1;
    }
    if (c == '\n') ++line;
    ++i;
  }
  return 0;
}

}  // namespace restenosis

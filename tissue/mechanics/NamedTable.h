#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace restenosis {

/// The names of a table's entries, in its order.
template <class Table>
std::vector<std::string_view> namesOf(const Table& table) {
  std::vector<std::string_view> names;
  for (const auto& entry : table) names.push_back(entry.name);
  return names;
}

/// The entry called `name`. Throws std::invalid_argument, which says `what` was looked for and which names
/// there are.
template <class Table>
const auto& findNamed(const Table& table, std::string_view what, std::string_view name) {
  std::string known;
  for (const auto& entry : table) {
    if (entry.name == name) return entry;
    known.append(known.empty() ? "" : ", ").append(entry.name);
  }
  throw std::invalid_argument(fmt::format("unknown {} '{}'; known: {}", what, name, known));
}

}  // namespace restenosis

#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <string_view>
#include <vector>

#include "tissue/parameters/NameList.h"

namespace restenosis {

/// A table entry of a name and a value.
template <class Value>
struct Named {
  std::string_view name;
  Value value;
};

/// The names of a table's entries, in its order.
template <class Table>
std::vector<std::string_view> namesOf(const Table& table) {
  std::vector<std::string_view> names;
  for (const auto& entry : table) names.push_back(entry.name);
  return names;
}

/// The entry called `name`. Throws std::invalid_argument with `what` was sought and, after `list`, the names
/// of the table.
template <class Table>
const auto& findNamed(const Table& table, std::string_view what, std::string_view name,
                      std::string_view list = "known:") {
  for (const auto& entry : table)
    if (entry.name == name) return entry;
  throw std::invalid_argument(
      fmt::format("unknown {} '{}'; {} {}", what, name, list, commaSeparated(namesOf(table))));
}

}  // namespace restenosis

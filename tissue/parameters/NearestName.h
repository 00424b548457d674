#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace restenosis {

/// The allowed name with the fewest edits from `name`: insertions, deletions, replacements and swaps of
/// neighbouring letters, regardless of case. Empty when none is near (more than two edits and more than a
/// third of its length).
std::string nearestName(std::string_view name, const std::vector<std::string_view>& allowed);

/// "; did you mean 'length'? Allowed: length, wallThickness"; the question only where a name is near.
std::string suggestion(std::string_view name, const std::vector<std::string_view>& allowed);

}  // namespace restenosis

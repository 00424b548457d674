#pragma once

#include <string_view>

namespace restenosis {

/// The program's version as git describes the tree it was built from, for example "v0.1.0-12-g3f2a9c1" or
/// "3f2a9c1-dirty"; the project's version where there is no git.
std::string_view version();

}  // namespace restenosis

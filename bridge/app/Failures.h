#pragma once

#include <functional>
#include <string_view>

namespace restenosis {

/// Does a command's work and returns its exit status. What ends it by an exception is told on standard error:
/// input that was refused is exit status 2, anything else 1. `interrupted`: what to say when the user has
/// ended it.
int exitStatusOf(const std::function<int()>& work, std::string_view interrupted);

}  // namespace restenosis

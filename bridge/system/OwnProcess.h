#pragma once

#include <functional>
#include <string>

namespace restenosis {

/// What `make` returns, made in a copy of this process: a library that crashes on a damaged file, or never
/// ends, takes that copy alone with it. `make` starts no threads and changes nothing but what it returns.
///
/// Throws std::runtime_error with the words of what `make` has thrown, or that it crashed or took longer than
/// a minute.
std::string inOwnProcess(const std::function<std::string()>& make);

}  // namespace restenosis

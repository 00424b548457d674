#pragma once

#include <cstddef>

namespace restenosis {

/// Loops over fewer items than this run on one thread: starting a team costs more than they do. No result
/// depends on it.
constexpr std::size_t parallelThreshold = 500;

}  // namespace restenosis

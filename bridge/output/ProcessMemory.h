#pragma once

#include <cstdint>

namespace restenosis {

/// Largest resident set of this process since the last `resetPeakMemory` [bytes]; where the system offers no
/// reset, since its start.
std::uint64_t peakMemory();
void resetPeakMemory();

/// Largest resident set of any child process that has ended and been waited for [bytes].
std::uint64_t peakChildMemory();

}  // namespace restenosis

#pragma once

namespace restenosis {

/// Scenes and output count in days; everything else counts in seconds.
inline constexpr double secondsPerDay = 86400;

}  // namespace restenosis

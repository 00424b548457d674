#pragma once

namespace restenosis {

/// A scene's author and what is written count in days; everything else counts in seconds.
inline constexpr double secondsPerDay = 86400;

}  // namespace restenosis

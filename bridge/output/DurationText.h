#pragma once

#include <string>

namespace restenosis {

/// Seconds as people say them: "42 s", "7 min 05 s", "3 h 20 min".
std::string durationText(double seconds);

}  // namespace restenosis

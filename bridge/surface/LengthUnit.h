#pragma once

#include <string_view>

namespace restenosis {

/// Length of the unit that a scene names for a surface file, one of "m", "cm", "mm" and "um" [m].
constexpr double metresPer(std::string_view unit) {
  return unit == "m" ? 1.0 : unit == "cm" ? 1e-2 : unit == "mm" ? 1e-3 : 1e-6;
}

}  // namespace restenosis

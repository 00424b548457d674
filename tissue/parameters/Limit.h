#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>

namespace restenosis {

/// Whether a value is beyond a limit that is computed from others, by more than rounding: 0.2 mm less 30 um
/// is 170 um for whoever types it.
inline bool exceeds(double value, double limit) { return value - limit > 1e-9 * std::abs(limit); }

/// A limit above 0 for people, of six digits, the last of which is rounded towards what is allowed: who types
/// what is shown is within it.
inline std::string shownAtMost(double limit) {
  constexpr int digits = 6;
  const double last = std::pow(10.0, std::floor(std::log10(limit)) + 1 - digits);
  return fmt::format("{:.{}g}", std::floor(limit / last * (1 + 1e-10)) * last, digits);
}
inline std::string shownAtLeast(double limit) {
  constexpr int digits = 6;
  const double last = std::pow(10.0, std::floor(std::log10(limit)) + 1 - digits);
  return fmt::format("{:.{}g}", std::ceil(limit / last * (1 - 1e-10)) * last, digits);
}

}  // namespace restenosis

#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>

namespace restenosis {

/// Whether a value is beyond a limit that is computed from others, by more than rounding: 0.2 mm less 30 um
/// is 170 um for whoever types it.
inline bool exceeds(double value, double limit) { return value - limit > 1e-9 * std::abs(limit); }

/// A limit for people, of six digits, the last of which `round` takes to a whole number; less than `slack` of
/// it is rounding of the limit itself.
template <class Round>
std::string shownRounded(double limit, double slack, Round&& round) {
  constexpr int digits = 6;
  if (limit == 0) return "0";
  const double last = std::pow(10.0, std::floor(std::log10(std::abs(limit))) + 1 - digits);
  return fmt::format("{:.{}g}", round(limit / last + slack) * last, digits);
}
/// A limit for people, the last digit of which is rounded towards what is allowed: who types what is shown is
/// within it.
inline std::string shownAtMost(double limit) {
  return shownRounded(limit, 5e-5, [](double x) { return std::floor(x); });
}
inline std::string shownAtLeast(double limit) {
  return shownRounded(limit, -5e-5, [](double x) { return std::ceil(x); });
}

}  // namespace restenosis

#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>

namespace restenosis {

/// Whether a value exceeds a computed limit by more than rounding: a limit of 0.2 mm - 30 um allows 170 um.
inline bool exceeds(double value, double limit) { return value - limit > 1e-9 * std::abs(limit); }

/// A limit for messages, of six digits; `round` rounds the last one. Less than `slack` of that digit is
/// rounding of the limit itself.
template <class Round>
std::string shownRounded(double limit, double slack, Round&& round) {
  constexpr int digits = 6;
  if (limit == 0) return "0";
  const double last = std::pow(10.0, std::floor(std::log10(std::abs(limit))) + 1 - digits);
  return fmt::format("{:.{}g}", round(limit / last + slack) * last, digits);
}
/// A limit for messages. Its last digit is rounded towards the allowed side, so the number shown is allowed.
inline std::string shownAtMost(double limit) {
  return shownRounded(limit, 5e-5, [](double x) { return std::floor(x); });
}
inline std::string shownAtLeast(double limit) {
  return shownRounded(limit, -5e-5, [](double x) { return std::ceil(x); });
}

}  // namespace restenosis

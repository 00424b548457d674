#include "bridge/output/DurationText.h"

#include <fmt/format.h>

#include <cmath>

namespace restenosis {

std::string durationText(double seconds) {
  const auto s = static_cast<long>(std::lround(seconds));
  if (s < 60) return fmt::format("{} s", s);
  if (s < 3600) return fmt::format("{} min {:02} s", s / 60, s % 60);
  return fmt::format("{} h {:02} min", s / 3600, s / 60 % 60);
}

}  // namespace restenosis

#include "tissue/agents/FixedScale.h"

#include <cmath>

namespace restenosis {

FixedScale::FixedScale(double length)
    : unit_(std::exp2(std::floor(std::log2(length)) - 22)), perUnit_(1 / unit_) {}

std::uint32_t FixedScale::wholeOfFar(double units) {
  constexpr double period = 4294967296.0;
  const double within = std::isfinite(units) ? std::fmod(units, period) : 0;
  return static_cast<std::uint32_t>(static_cast<std::int64_t>(within));
}

}  // namespace restenosis

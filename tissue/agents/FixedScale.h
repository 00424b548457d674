#pragma once

#include <cmath>
#include <cstdint>

#include "tissue/agents/AgentStore.h"

namespace restenosis {

/// A place in whole units of a FixedScale, modulo 2^32.
struct FixedPlace {
  std::uint32_t x, y, z;
};

/// Positions as whole numbers of a unit. Differences of them are exact and the same wherever the agents are,
/// so that single precision is enough for all that follows. They are modulo 2^32: true between places less
/// than `reach` apart, wherever in space they lie.
class FixedScale {
 public:
  /// The unit is the power of two just below `length` 2^-22 [m].
  explicit FixedScale(double length);

  double unit() const { return unit_; }
  /// Half the period [m]: about 500 lengths.
  double reach() const { return unit_ * 2147483648.0; }
  FixedPlace of(const Vec3& position) const {
    return {whole(position.x()), whole(position.y()), whole(position.z())};
  }

 private:
  std::uint32_t whole(double coordinate) const {
    const double units = std::nearbyint(coordinate * perUnit_);
    if (!(std::abs(units) < 0x1p62)) return wholeOfFar(units);
    return static_cast<std::uint32_t>(static_cast<std::int64_t>(units));
  }
  static std::uint32_t wholeOfFar(double units);

  double unit_;
  double perUnit_;
};

}  // namespace restenosis

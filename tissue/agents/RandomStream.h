#pragma once

#include <Random123/philox.h>

#include <cmath>
#include <cstdint>
#include <numbers>

#include "tissue/agents/AgentStore.h"

namespace restenosis {

/// What a random number is drawn for. Values are part of a run's identity: append, never renumber.
enum class RandomPurpose : std::uint32_t {
  packing = 1,
  radius = 2,
  g1Duration = 3,
  divisionDirection = 4,
  fenestration = 5,
  endotheliumSeeding = 6,
  recruitment = 7,
  activation = 8
};

/// Counter-based random numbers (Philox 4x32-10, Salmon et al. 2011): a draw is a function of (seed, agent,
/// step, purpose, draw number) alone, so neither threads nor the order of agents nor a restart can change it.
class RandomStream {
 public:
  RandomStream(std::uint64_t seed, AgentId agent, std::uint32_t step, RandomPurpose purpose)
      : key_{{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)}},
        counter_{{static_cast<std::uint32_t>(agent), static_cast<std::uint32_t>(agent >> 32), step,
                  static_cast<std::uint32_t>(purpose) << 16}} {}

  /// Uniform in [0, 1) with 53 random bits.
  double uniform() {
    if (next_ == 4) refill();
    const std::uint64_t low = block_.v[next_++];
    const std::uint64_t high = block_.v[next_++];
    return static_cast<double>((high << 32 | low) >> 11) * 0x1p-53;
  }

  /// Standard normal (Box-Muller).
  double normal() {
    const double u = 1.0 - uniform();
    return std::sqrt(-2.0 * std::log(u)) * std::cos(2.0 * std::numbers::pi * uniform());
  }

  /// Uniform on the unit sphere: uniform height and uniform longitude.
  Vec3 direction() {
    const double height = 2.0 * uniform() - 1.0;
    const double longitude = 2.0 * std::numbers::pi * uniform();
    const double ring = std::sqrt(1.0 - height * height);
    return {ring * std::cos(longitude), ring * std::sin(longitude), height};
  }

 private:
  void refill() {
    block_ = r123::Philox4x32()(counter_, key_);
    ++counter_.v[3];
    next_ = 0;
  }

  r123::Philox4x32::key_type key_;
  r123::Philox4x32::ctr_type counter_;
  r123::Philox4x32::ctr_type block_{};
  int next_ = 4;
};

}  // namespace restenosis

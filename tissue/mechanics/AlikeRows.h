#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>
#include <span>

#include "PairTable.h"

namespace restenosis {

/// Few agents in an order that brings together rows of like length, those with pairs marked for a daughter
/// last: the lanes of the force loop wait for the longest of their rows, and all compute cohesion where one
/// does. Speed only.
class AlikeRows {
 public:
  static constexpr std::size_t most = 256;

  /// Of at most `most` agents.
  AlikeRows(const PairTable& pairs, std::span<const Index> agents) {
    assert(agents.size() <= most);
    std::array<std::uint8_t, most> kind;
    std::array<std::uint16_t, 2 * lengths + 1> start{};
    for (std::size_t k = 0; k < agents.size(); ++k) {
      const std::uint32_t length = std::min(pairs.length(agents[k]), lengths - 1);
      kind[k] = static_cast<std::uint8_t>(length + (pairs.marked(agents[k]) ? lengths : 0));
      ++start[kind[k] + 1U];
    }
    for (std::size_t n = 1; n < start.size(); ++n) start[n] += start[n - 1];
    for (std::size_t k = 0; k < agents.size(); ++k) order_[start[kind[k]]++] = static_cast<std::uint8_t>(k);
  }

  /// The place among the agents of the n-th in this order.
  std::size_t operator[](std::size_t n) const { return order_[n]; }

 private:
  static constexpr std::uint32_t lengths = 64;  // that are told apart; the last stands for all beyond it
  std::array<std::uint8_t, most> order_;
};

}  // namespace restenosis

#pragma once

#include <array>
#include <cstdint>

namespace restenosis::d3q19 {

/// The lattice velocities: rest, then nine pairs of opposite directions, the first of a pair pointing to
/// larger coordinates. Weights 1/3, 1/18 (along an axis) and 1/36 (diagonal); the speed of sound squared is
/// 1/3.
inline constexpr int directions = 19;
inline constexpr int pairs = 9;
using Step = std::array<int, 3>;
inline constexpr std::array<Step, directions> c = {{{0, 0, 0},
                                                    {1, 0, 0},
                                                    {-1, 0, 0},
                                                    {0, 1, 0},
                                                    {0, -1, 0},
                                                    {0, 0, 1},
                                                    {0, 0, -1},
                                                    {1, 1, 0},
                                                    {-1, -1, 0},
                                                    {1, -1, 0},
                                                    {-1, 1, 0},
                                                    {1, 0, 1},
                                                    {-1, 0, -1},
                                                    {1, 0, -1},
                                                    {-1, 0, 1},
                                                    {0, 1, 1},
                                                    {0, -1, -1},
                                                    {0, 1, -1},
                                                    {0, -1, 1}}};

/// The node beside node `n` in a direction.
constexpr Step moved(const Step& n, int direction) {
  const Step& s = c[static_cast<std::size_t>(direction)];
  return {n[0] + s[0], n[1] + s[1], n[2] + s[2]};
}

constexpr int opposite(int direction) { return direction == 0 ? 0 : ((direction - 1) ^ 1) + 1; }

constexpr double weight(int direction) {
  const Step& s = c[static_cast<std::size_t>(direction)];
  const int square = s[0] * s[0] + s[1] * s[1] + s[2] * s[2];
  return square == 0 ? 1.0 / 3.0 : square == 1 ? 1.0 / 18.0 : 1.0 / 36.0;
}

}  // namespace restenosis::d3q19

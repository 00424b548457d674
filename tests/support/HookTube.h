#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "tests/support/SweptTube.h"

namespace restenosis::support {

/// A tube that runs along z from the origin for `before`, turns by 180 degrees towards x about an arc of
/// radius `bend`, and comes back along -z for `after` [m]. With `before` = `after` its ends lie in one plane.
inline TriSurface hookTube(double radius, double before, double bend, double after,
                           std::uint32_t sides = 96) {
  constexpr int arcPieces = 32, straightPieces = 6;
  std::vector<AxisPoint> axis;
  if (before > 0.0)
    for (int i = 0; i < straightPieces; ++i)
      axis.push_back({Vec3(0, 0, before * i / straightPieces), Vec3::UnitZ()});
  for (int i = 0; i <= arcPieces; ++i) {
    const double turn = std::numbers::pi * i / arcPieces;
    axis.push_back({Vec3(bend * (1 - std::cos(turn)), 0, before + bend * std::sin(turn)),
                    Vec3(std::sin(turn), 0, std::cos(turn))});
  }
  if (after > 0.0)
    for (int i = 1; i <= straightPieces; ++i)
      axis.push_back({Vec3(2 * bend, 0, before - after * i / straightPieces), -Vec3::UnitZ()});
  return sweptTube(axis, radius, sides);
}

/// A ring of 270 degrees about the y axis, 2 mm wide, of a tube 0.8 mm wide: what goes on straight from its
/// ends meets, 1 mm from each.
inline TriSurface openRing() {
  constexpr int pieces = 54;
  std::vector<AxisPoint> axis;
  for (int i = 0; i <= pieces; ++i) {
    const double turn = 1.5 * std::numbers::pi * i / pieces;
    axis.push_back(
        {1e-3 * Vec3(1 - std::cos(turn), 0, std::sin(turn)), Vec3(std::sin(turn), 0, std::cos(turn))});
  }
  return sweptTube(axis, 0.4e-3, 48);
}

}  // namespace restenosis::support

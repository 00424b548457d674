#pragma once

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>
#include <utility>

namespace restenosis {

/// The table of a wall of four layers along 0.2 mm, from 0.25 to 0.37 mm from the axis, whose agents overlap
/// by a little around it: all lengths times `scale`, moved in x by `shift` [um].
inline std::string fourLayers(double scale = 1, double shift = 0) {
  std::string rows = "x,y,z,radius,kind\n";
  for (const auto& [radius, kind] : {std::pair(265, "iel"), {295, "smc"}, {325, "smc"}, {355, "eel"}}) {
    const int around = static_cast<int>(2 * std::numbers::pi * radius / 28);
    for (int k = 0; k < 8; ++k) {
      for (int j = 0; j < around; ++j) {
        const double angle = 2 * std::numbers::pi * (j + 0.5 * (k % 2)) / around;
        rows += fmt::format("{},{},{},{},{}\n", scale * (radius * std::cos(angle) + shift),
                            scale * radius * std::sin(angle), scale * (5 + 27 * k), scale * 15, kind);
      }
    }
  }
  return rows;
}

}  // namespace restenosis

#include "StentDesign.h"

#include <fmt/format.h>

#include <array>
#include <stdexcept>
#include <string>

namespace restenosis {

std::span<const StentDesign> stentDesigns() {
  static constexpr std::array<StentDesign, 5> table = {{
      {"ring", "one ring half way along", false, buildRing},
      {"rings", "rings evenly over the stent's length", true, buildRings},
      {"ringsWithLinks", "rings joined by straight links", true, buildRingsWithLinks},
      {"helix", "a helix", true, buildHelix},
      {"biodivysio", "sinusoidal rings joined by links", true, buildBiodivysio},
  }};
  return table;
}

std::vector<std::string_view> stentDesignNames() {
  std::vector<std::string_view> names;
  for (const StentDesign& design : stentDesigns()) names.push_back(design.name);
  return names;
}

const StentDesign& stentDesign(std::string_view name) {
  for (const StentDesign& design : stentDesigns()) {
    if (design.name == name) return design;
  }
  std::string allowed;
  for (const StentDesign& design : stentDesigns()) {
    allowed.append(allowed.empty() ? "" : ", ").append(design.name);
  }
  throw std::invalid_argument(fmt::format("unknown stent design '{}'; allowed are {}", name, allowed));
}

}  // namespace restenosis

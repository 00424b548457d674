#include "StentDesign.h"

#include <array>

#include "NamedTable.h"

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

std::vector<std::string_view> stentDesignNames() { return namesOf(stentDesigns()); }

const StentDesign& stentDesign(std::string_view name) {
  return findNamed(stentDesigns(), "stent design", name, "allowed are");
}

}  // namespace restenosis

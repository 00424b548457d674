#include "tissue/stent/StentDesign.h"

#include <array>

#include "tissue/parameters/NamedTable.h"

namespace restenosis {

namespace {

constexpr std::array designs{
    StentDesign{"ring", false, buildRing, checkRing},
    StentDesign{"rings", true, buildRings, checkRings},
    StentDesign{"ringsWithLinks", true, buildRingsWithLinks, checkRings},
    StentDesign{"helix", true, buildHelix, checkHelix},
    StentDesign{"biodivysio", true, buildBiodivysio, checkBiodivysio},
};

}  // namespace

std::vector<std::string_view> stentDesignNames() { return namesOf(designs); }

const StentDesign& stentDesign(std::string_view name) {
  return findNamed(designs, "stent design", name, "allowed are");
}

}  // namespace restenosis

#include "StentDesign.h"

#include <array>

#include "NamedTable.h"

namespace restenosis {

namespace {

constexpr std::array designs{
    StentDesign{"ring", false, buildRing},
    StentDesign{"rings", true, buildRings},
    StentDesign{"ringsWithLinks", true, buildRingsWithLinks},
    StentDesign{"helix", true, buildHelix},
    StentDesign{"biodivysio", true, buildBiodivysio},
};

}  // namespace

std::vector<std::string_view> stentDesignNames() { return namesOf(designs); }

const StentDesign& stentDesign(std::string_view name) {
  return findNamed(designs, "stent design", name, "allowed are");
}

}  // namespace restenosis

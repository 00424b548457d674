#include <gtest/gtest.h>

#include "bridge/surface/SolidNames.h"

namespace restenosis {
namespace {

using enum SurfaceRegion;
using Meanings = std::vector<SurfaceRegion>;

void expectMeaning(const Meanings& expected, std::initializer_list<const char*> names) {
  for (const char* name : names) EXPECT_EQ(meaningsOf(name), expected) << name;
}

TEST(SolidNames, WholeWordsSayWhatASolidIs) {
  expectMeaning(
      {inlet},
      {"inlet",  "INLET",  "Inlet-Cap", "inlet1",   "1inlet",      "the inlet",       "vesselInlet",
       "inflow", "InFlow", "in-flow",   "STLInlet", "lumen inlet", "artery_inflow_2", "inlet.001",
       "in",     "In",     "in1",       "cap_in",   "in-cap",      "inlet in mm",     "Einlass inlet"});
  expectMeaning({outlet},
                {"outlet", "OUTFLOW", "outlet_2", "outFlow", "out", "OUT_1", "lumenOut", "Outlets"});
  expectMeaning({wall}, {"wall", "Wall1", "walls", "lumen", "vessel", "LumenWall", "artery", "wall in mm",
                         "stented vessel", "stented segment", "lumen in mm", "a region"});
  expectMeaning({strut},
                {"stent", "strut", "strut_2", "STRUTS", "Stents", "stentStruts", "strut12", "stent in mm"});
}

TEST(SolidNames, PartsOfWordsSayNothing) {
  expectMeaning({}, {"", "stented", "unstented", "constrained", "instrument", "inletted"});
  expectMeaning({},
                {"proximal", "written in mm", "cut out of a scan", "within", "route", "42", "inlet\xC3\xA9"});
}

TEST(SolidNames, ManyThingsAtOnceAreAllSaid) {
  expectMeaning({inlet, outlet},
                {"STL of lumen with inlet and outlet caps, units mm", "inlet/outlet", "in-out"});
  expectMeaning({wall, inlet}, {"wall_inlet"});
  expectMeaning({inlet, wall}, {"inletWall"});
  expectMeaning({strut, wall},
                {"stent segment", "lumen with stent", "in-stent", "stent region", "stent and wall"});
}

TEST(SolidNames, SolidsAreShown) {
  const std::vector<std::string> names{"a", "", "b\x1B[2J", "c", "d"};
  EXPECT_EQ(shownSolids(names, {0}), "the solid 'a'");
  EXPECT_EQ(shownSolids(names, {0, 1}), "the solids 'a' and 2");
  EXPECT_EQ(shownSolids(names, {0, 1, 2}), "the solids 'a', 2 and 'b\\x1b[2J'");
  EXPECT_EQ(shownSolids(names, {0, 1, 2, 3}), "4 solids ('a', 2, 'b\\x1b[2J', ...)");
}

}  // namespace
}  // namespace restenosis

#include <gtest/gtest.h>

#include <sstream>
#include <stdexcept>

#include "bridge/flow/foam/FoamLog.h"
#include "bridge/flow/foam/FoamTemplate.h"
#include "bridge/flow/foam/LumenCase.h"
#include "bridge/flow/foam/LumenStl.h"
#include "bridge/surface/StlFile.h"
#include "bridge/surface/SurfaceEnds.h"
#include "tests/support/AnnularTube.h"
#include "tests/support/Constants.h"
#include "tests/support/FlowSupport.h"
#include "tests/support/HookTube.h"
#include "tests/support/SweptTube.h"
#include "tests/support/TemporaryFolder.h"
#include "tests/support/TubeSurface.h"

namespace restenosis {
namespace {

using namespace support;

DictionaryText templateParameters() {
  return DictionaryText(foamLog::read(foamTemplate() / "system/lumenParameters"));
}

/// A number, in quotes or not.
double numberOf(const DictionaryText& text, const char* key) {
  const std::string value = text.get(key);
  return std::stod(value.starts_with('"') ? value.substr(1) : value);
}

TEST(LumenCase, numbersAreWrittenInSiUnits) {
  const auto settings = FoamSettings::forFidelity("draft");
  const auto lumen = measureLumen(stentedTube(vesselRadius, vesselLength, 90e-6), settings);
  auto text = templateParameters();
  writeLumenParameters(text, lumen, vesselConditions(), settings, Effort::normal, 1);
  const auto number = [&](const char* key) { return numberOf(text, key); };
  EXPECT_NEAR(number("kinematicViscosity"), 2.7e-6, 1e-18);
  EXPECT_NEAR(number("flowRate"), 3.384438e-7, 1e-12);
  EXPECT_NEAR(number("inletRadius"), 0.9e-3, 1e-12);
  EXPECT_NEAR(number("zMax"), 1.2e-3, 1e-15);
  EXPECT_EQ(text.get("ends"), "cut");
  EXPECT_EQ(text.get("coreLevel"), "0");
  EXPECT_NEAR(number("pressureDrop"), 4.256e-3, 1e-7);
  EXPECT_EQ(number("cellsZ"), 13);
  EXPECT_NEAR((number("xMax") - number("xMin")) / number("cellsX"), 0.09e-3, 1e-15);
  EXPECT_GT(number("xMax"), 0.9e-3 + 0.09e-3);
  EXPECT_EQ(text.get("struts"), "yes");
  EXPECT_EQ(text.get("drive"), "flowRate");
  EXPECT_EQ(text.get("skewFaces"), "10");
  EXPECT_EQ(number("skewness"), 20);
}

TEST(LumenCase, aBentLumenIsMeshedWithItsCaps) {
  const auto settings = FoamSettings::forFidelity("draft");
  const TriSurface bent = bentTube(vesselRadius, 1e-3, 2e-3, 1e-3);
  EXPECT_EQ(measureLumen(bent, settings).ends, LumenEnds::inletCut);  // it begins along z
  const auto lumen = measureLumen(moved(bent, motionTo(Vec3(1, 2, 3), Vec3(0, 0, 0))), settings);
  const double axis = 2e-3 + 1e-3 * std::numbers::pi;
  EXPECT_NEAR(lumen.length() / axis, 1.0, 0.01);
  auto text = templateParameters();
  writeLumenParameters(text, lumen, vesselConditions(), settings, Effort::normal, 1);
  const auto number = [&](const char* key) { return numberOf(text, key); };
  EXPECT_EQ(text.get("ends"), "caps");
  EXPECT_LT(number("zMin"), -0.09e-3);
  EXPECT_NEAR((number("zMax") - number("zMin")) / number("cellsZ"), 0.09e-3, 1e-15);
}

/// A plane that cuts the inlet would cut the outlet off as well.
TEST(LumenCase, endsInOnePlaneAreCaps) {
  const auto settings = FoamSettings::forFidelity("draft");
  for (const double offset : {0.0, 1e-9, -1e-9, 0.1e-3})
    EXPECT_EQ(measureLumen(hookTube(vesselRadius, 1e-3, 1.3e-3, 1e-3 + offset), settings).ends,
              LumenEnds::caps)
        << offset;
  EXPECT_EQ(measureLumen(hookTube(vesselRadius, 1e-3, 1.3e-3, 0.7e-3), settings).ends, LumenEnds::inletCut);
}

TEST(LumenCase, theSecondAttemptNamesAnotherPointInside) {
  const auto settings = FoamSettings::forFidelity("draft");
  const auto lumen = measureLumen(tube(vesselRadius, vesselLength), settings);
  auto first = templateParameters(), second = templateParameters();
  writeLumenParameters(first, lumen, vesselConditions(), settings, Effort::normal, 1);
  writeLumenParameters(second, lumen, vesselConditions(), settings, Effort::robust, 1);
  EXPECT_NE(first.get("insidePoint"), second.get("insidePoint"));
}

TEST(LumenCase, aLongLumenGetsACoarserBlock) {
  const auto settings = FoamSettings::forFidelity("draft");
  const auto lumen = measureLumen(bentTube(vesselRadius, 30e-3, 2e-3, 30e-3), settings);
  auto text = templateParameters();
  writeLumenParameters(text, lumen, vesselConditions(), settings, Effort::normal, 1);
  const auto number = [&](const char* key) { return numberOf(text, key); };
  EXPECT_LE(number("cellsX") * number("cellsY") * number("cellsZ"), 1.5e6);
  EXPECT_EQ(number("coreLevel"), 1);
  const double block = (number("xMax") - number("xMin")) / number("cellsX");
  EXPECT_NEAR(block / std::exp2(number("coreLevel")), 0.09e-3, 1e-15);
  EXPECT_EQ(number("wallLevel"), number("coreLevel") + 1);
}

TEST(LumenCase, robustEffortChangesMesherAndSolver) {
  const auto settings = FoamSettings::forFidelity("draft");
  const auto lumen = measureLumen(tube(vesselRadius, vesselLength), settings);
  auto text = templateParameters();
  writeLumenParameters(text, lumen, vesselConditions(), settings, Effort::robust, 1);
  EXPECT_EQ(text.get("meshing"), "thorough");
  EXPECT_EQ(text.get("relaxation"), "0.6000000000000001");
  EXPECT_EQ(text.get("struts"), "no");
}

/// minimumCellsAcross is asked of the lumen before the run; a run in which tissue narrows the inlet goes on.
TEST(LumenCase, anInletThatTissueHasNarrowedIsMeshed) {
  const auto settings = FoamSettings::forFidelity("draft");
  EXPECT_NO_THROW(measureLumen(tube(0.2e-3, vesselLength), settings));  // 2.2 cells of the core
  EXPECT_THROW(measureLumen(tube(0.04e-3, vesselLength), settings), std::invalid_argument);
}

TEST(LumenCase, thePointInsideAnAnnulusIsNotItsCentre) {
  const auto settings = FoamSettings::forFidelity("draft");
  const auto lumen = measureLumen(annularTube(0.9e-3, 0.5e-3, vesselLength), settings);
  auto text = templateParameters();
  writeLumenParameters(text, lumen, vesselConditions(), settings, Effort::normal, 1);
  Vec3 inside;
  std::istringstream(text.get("insidePoint").substr(1)) >> inside.x() >> inside.y() >> inside.z();
  EXPECT_GT(inside.head<2>().norm(), 0.55e-3);
  EXPECT_LT(inside.head<2>().norm(), 0.85e-3);
}

TEST(LumenCase, wrongScaleIsNamed) {
  const auto settings = FoamSettings::forFidelity("draft");
  for (const double scale : {1e-3, 1e3}) try {
      measureLumen(tube(scale * vesselRadius, scale * vesselLength), settings);
      ADD_FAILURE() << scale;
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find("length unit"), std::string::npos);
    }
}

TEST(LumenStl, wallAndStrutsOvershootTheEnds) {
  const TemporaryFolder scratch;
  const auto file = scratch.path() / "lumen.stl";
  writeLumenStl(tube(1e-3, 1e-3, 1), LumenEnds::cut, 0.2e-3, file);
  const auto plain = foamLog::read(file);
  EXPECT_TRUE(plain.starts_with("solid wall\n"));
  EXPECT_EQ(plain.find("strut"), std::string::npos);
  std::size_t facets = 0;
  for (auto at = plain.find("endfacet"); at != std::string::npos; at = plain.find("endfacet", at + 1))
    ++facets;
  EXPECT_EQ(facets, 3u * 256u);  // the tube and a rim at either end
  EXPECT_NE(plain.find(" -0.0002\n"), std::string::npos);
  EXPECT_NE(plain.find(" 0.0012\n"), std::string::npos);
  writeLumenStl(stentedTube(1e-3, 1e-3, 1e-4), LumenEnds::cut, 0.2e-3, file);
  EXPECT_NE(foamLog::read(file).find("endsolid wall\nsolid strut\n"), std::string::npos);
}

TEST(LumenStl, endsThatAreNotCutAreSolids) {
  const TemporaryFolder scratch;
  const TriSurface bent = bentTube(1e-3, 1e-3, 2e-3, 1e-3);
  writeLumenStl(bent, LumenEnds::caps, 0.2e-3, scratch / "caps.stl");
  const auto caps = readSurfaceSolids(scratch / "caps.stl", 1.0);
  EXPECT_EQ(caps.names, (std::vector<std::string>{"wall", "inlet", "outlet"}));
  EXPECT_TRUE(surfaceEdges(caps.surface).open.empty());
  writeLumenStl(bent, LumenEnds::inletCut, 0.2e-3, scratch / "inletCut.stl");
  const auto inletCut = readSurfaceSolids(scratch / "inletCut.stl", 1.0);
  EXPECT_EQ(inletCut.names, (std::vector<std::string>{"wall", "outlet"}));
  EXPECT_TRUE(surfaceEdges(inletCut.surface).open.empty());
  EXPECT_NEAR(enclosedVolume(inletCut.surface) - enclosedVolume(bent), 1e-6 * std::numbers::pi * 0.2e-3,
              1e-14);
}

TEST(LumenStl, rimsOfCapsAreWritten) {
  const TemporaryFolder scratch;
  const TriSurface bent = bentTube(1e-3, 1e-3, 2e-3, 1e-3);
  const auto lines = [&](LumenEnds ends) {
    writeRims(bent, ends, scratch / "rims.obj");
    const std::string text = foamLog::read(scratch / "rims.obj");
    std::size_t count = 0;
    for (auto at = text.find("\nl "); at != std::string::npos; at = text.find("\nl ", at + 1)) ++count;
    return count;
  };
  EXPECT_EQ(lines(LumenEnds::caps), 2u * 96u);
  EXPECT_EQ(lines(LumenEnds::inletCut), 96u);
}

TEST(FoamTemplate, foreignFilesAreNotOverwritten) {
  const TemporaryFolder scratch;
  copyFoamTemplate(foamTemplate(), scratch.path() / "case");
  EXPECT_TRUE(std::filesystem::exists(scratch.path() / "case/0.orig/U"));
  EXPECT_NO_THROW(copyFoamTemplate(foamTemplate(), scratch.path() / "case"));
  EXPECT_THROW(copyFoamTemplate(foamTemplate(), scratch.path()), std::runtime_error);
}

TEST(FoamTemplate, whatAKilledRunLeftHalfCopiedDoesNotMatter) {
  const TemporaryFolder scratch;
  std::filesystem::create_directories(scratch / "case.partial/system");
  writeText(scratch / "case.partial/stray", "");
  copyFoamTemplate(foamTemplate(), scratch / "case");
  EXPECT_TRUE(std::filesystem::exists(scratch / "case/system/lumenParameters"));
  EXPECT_FALSE(std::filesystem::exists(scratch / "case/stray"));
  EXPECT_FALSE(std::filesystem::exists(scratch / "case.partial"));
}

}  // namespace
}  // namespace restenosis

#include <gtest/gtest.h>

#include "bridge/surface/SceneStent.h"
#include "bridge/surface/StlFile.h"
#include "tests/support/StrutSolids.h"
#include "tests/support/TemporaryFolder.h"
#include "tissue/vessel/Cylindrical.h"

namespace restenosis {
namespace {

using namespace support;

/// A ring of a square section of 60 um for a lumen of radius 250 um.
class SceneStent : public testing::Test {
 protected:
  SceneStent() {
    vessel.length = 0.2e-3;
    vessel.lumenDiameter = 0.5e-3;
    vessel.wallThickness = 0.12e-3;
    vessel.cellRadius = 18e-6;
  }
  void write(const std::string& name, const TriSurface& surface, double metresPerUnit = 1e-3) {
    stent.file = (folder / name).string();
    writeStl(stent.file, surface, metresPerUnit);
  }
  std::string refusal() const {
    try {
      makeStent(stent, vessel);
      return "accepted";
    } catch (const std::runtime_error& error) {
      EXPECT_TRUE(std::string(error.what()).starts_with(stent.file)) << error.what();
      return error.what();
    }
  }
  static double outermost(const Stent& placed) {
    double reach = 0;
    for (std::size_t n = 0; n < placed.spheres.size(); ++n)
      reach = std::max(reach, radiusOf(placed.centre(n)) + placed.spheres[n].radius);
    return reach;
  }

  TemporaryFolder folder;
  VesselParameters vessel;
  StentParameters stent;
  const TriSurface good = squareRing(0.25e-3, 60e-6, 0.2e-3, 60);
};

#define EXPECT_NAMES(text, part) EXPECT_NE((text).find(part), std::string::npos) << (text)

TEST_F(SceneStent, TheNameOfTheFileDecidesInAnyCase) {
  for (const char* name : {"a.stl", "b.STL", "c.Stl"}) {
    write(name, good);
    const Stent placed = makeStent(stent, vessel);
    EXPECT_EQ(placed.segments.size(), placed.spheres.size());
    EXPECT_GT(placed.spheres.size(), 500u);
    EXPECT_NEAR(outermost(placed), 250e-6, 1e-12);
  }
  stent.file = (folder / "table.csv").string();
  writeText(stent.file, "x,y,z,radius\n230,0,100,20\n");
  EXPECT_EQ(makeStent(stent, vessel).spheres.size(), 1u);
  stent.file.clear();
  EXPECT_GT(makeStent(stent, vessel).spheres.size(), 500u);
}

TEST_F(SceneStent, TheSpheresOfASurfaceAreThoseOfATable) {
  write("ring.stl", good);
  const Stent surface = makeStent(stent, vessel);
  writeAgentTable(folder / "ring.csv", readStruts(stent, vessel).agents);
  stent.file = (folder / "ring.csv").string();
  const Stent table = makeStent(stent, vessel);
  ASSERT_EQ(surface.spheres.size(), table.spheres.size());
  for (std::size_t n = 0; n < table.spheres.size(); ++n)
    EXPECT_LT((surface.centre(n) - table.centre(n)).norm(), 1e-12);
}

TEST_F(SceneStent, ACrimpedRingIsMovedToTheLumen) {
  write("crimped.stl", squareRing(0.2e-3, 60e-6, 0.2e-3, 60));
  EXPECT_NEAR(outermost(makeStent(stent, vessel)), 250e-6, 1e-12);
}

TEST_F(SceneStent, UnitsAreThoseOfTheScene) {
  write("um.stl", good, 1e-6);
  stent.fileUnit = "um";
  EXPECT_EQ(refusal(), "accepted");
  stent.fileUnit = "mm";
  EXPECT_NAMES(refusal(), "allowed are 0 to 200 um (vessel.length). Its length unit is taken to be mm");
  write("mm.stl", good);
  stent.fileUnit = "m";
  EXPECT_NAMES(refusal(), "taken to be m (fileUnit)");
  stent.fileUnit = "um";
  EXPECT_NAMES(refusal(), "thinner than 2 um");
}

TEST_F(SceneStent, WhatDoesNotFitIsNamed) {
  write("long.stl", squareRing(0.25e-3, 60e-6, 0.4e-3, 60));
  EXPECT_NAMES(refusal(), "the struts reach from z = 170 to 230 um; allowed are 0 to 200 um");
  write("wide.stl", squareRing(0.8e-3, 60e-6, 0.2e-3, 60));
  EXPECT_NAMES(refusal(), "the struts reach 800 um from the axis (x = y = 0); allowed are at most 555 um");
  write("deep.stl", together(good, box({60e-6, 0, 70e-6}, {110e-6, 50e-6, 120e-6})));
  EXPECT_NAMES(refusal(), "further in than the outermost one (at (");
}

}  // namespace
}  // namespace restenosis

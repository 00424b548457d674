#include <gtest/gtest.h>

#include <numbers>

#include "bridge/surface/CylinderSurface.h"
#include "bridge/surface/SurfaceCheck.h"

namespace restenosis {
namespace {

TEST(CylinderSurface, HasTheVolumeAndAreasOfTheCylinder) {
  VesselParameters vessel;
  vessel.length = 1.2e-3;
  const SurfaceReport report = checkSurface(cylinderSurface(vessel), vessel.length);
  EXPECT_TRUE(report.good()) << report.summary();
  const double section = std::numbers::pi * 0.81e-6;
  EXPECT_NEAR(report.volume, section * 1.2e-3, 1e-10 * section);
  EXPECT_NEAR(report.areaOf(SurfaceRegion::inlet), section, 1e-10 * section);
  EXPECT_NEAR(report.areaOf(SurfaceRegion::outlet), section, 1e-10 * section);
  const double wall = 2 * std::numbers::pi * 0.9e-3 * 1.2e-3;
  EXPECT_NEAR(report.areaOf(SurfaceRegion::wall), wall, 1e-4 * wall);
}

TEST(CylinderSurface, NarrowsToTheStenosis) {
  VesselParameters vessel;
  vessel.stenosis = 0.5;
  EXPECT_DOUBLE_EQ(cylinderRadius(vessel, 0.5 * vessel.length), 0.45e-3);
  EXPECT_DOUBLE_EQ(cylinderRadius(vessel, 0), 0.9e-3);
  EXPECT_NEAR(cylinderRadius(vessel, 0.5 * vessel.length + 0.25 * vessel.stenosisLength), 0.675e-3, 1e-12);
  const SurfaceReport report = checkSurface(cylinderSurface(vessel, {40e-6, 40e-6}), vessel.length);
  EXPECT_TRUE(report.good()) << report.summary();
}

TEST(CylinderSurface, ScalesWithTheVessel) {
  VesselParameters usual;
  usual.length = 0.6e-3;
  EXPECT_EQ(cylinderSpacing(usual).around, 20e-6);
  EXPECT_EQ(cylinderSpacing(usual).along, 20e-6);
  const TriSurface surface = cylinderSurface(usual);
  for (const double scale : {1.0 / 9, 10.0}) {
    VesselParameters vessel;
    vessel.lumenDiameter = scale * usual.lumenDiameter;
    vessel.length = scale * usual.length;
    const TriSurface scaled = cylinderSurface(vessel);
    ASSERT_EQ(scaled.triangles, surface.triangles) << scale;
    for (std::size_t v = 0; v < surface.vertices.size(); ++v)
      EXPECT_LT((scaled.vertices[v] / scale - surface.vertices[v]).norm(), 1e-15) << v;
  }
}

TEST(CylinderSurface, OfALongNarrowVesselHasLongTriangles) {
  VesselParameters vessel;
  vessel.lumenDiameter = 0.18e-3;  // triangles 2 um wide
  vessel.length = 20e-3;
  EXPECT_DOUBLE_EQ(cylinderSpacing(vessel).along, 2e-6);
  vessel.length = 50e-3;
  EXPECT_DOUBLE_EQ(cylinderSpacing(vessel).around, 2e-6);
  EXPECT_DOUBLE_EQ(cylinderSpacing(vessel).along, 5e-6);
  vessel.length = 500e-3;
  EXPECT_DOUBLE_EQ(cylinderSpacing(vessel).along, 20e-6);
}

TEST(CylinderSurface, RefusesAClosedVessel) {
  VesselParameters vessel;
  vessel.stenosis = 1.0;
  EXPECT_THROW(cylinderSurface(vessel), std::invalid_argument);
  EXPECT_THROW(cylinderSurface({}, {0, 20e-6}), std::invalid_argument);
}

}  // namespace
}  // namespace restenosis

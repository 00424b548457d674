#include <gtest/gtest.h>

#include <numbers>

#include "CylinderSurface.h"
#include "SurfaceCheck.h"

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
  const SurfaceReport report = checkSurface(cylinderSurface(vessel, 40e-6), vessel.length);
  EXPECT_TRUE(report.good()) << report.summary();
}

TEST(CylinderSurface, RefusesAClosedVessel) {
  VesselParameters vessel;
  vessel.stenosis = 1.0;
  EXPECT_THROW(cylinderSurface(vessel), std::invalid_argument);
  EXPECT_THROW(cylinderSurface({}, 0), std::invalid_argument);
}

}  // namespace
}  // namespace restenosis

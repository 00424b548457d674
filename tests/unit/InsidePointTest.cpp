#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bridge/flow/foam/InsidePoint.h"
#include "bridge/flow/foam/LumenCase.h"
#include "bridge/surface/NearestTriangle.h"
#include "tests/support/AnnularTube.h"
#include "tests/support/Constants.h"
#include "tests/support/HookTube.h"
#include "tests/support/TubeSurface.h"

namespace restenosis {
namespace {

using namespace support;

/// How often a closed surface winds around a place: 1 inside, 0 outside; the sum of its triangles' solid
/// angles.
double windingNumber(const TriSurface& s, const Vec3& place) {
  double sum = 0.0;
  for (const auto& t : s.triangles) {
    const Vec3 a = s.vertices[t[0]] - place, b = s.vertices[t[1]] - place, c = s.vertices[t[2]] - place;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    sum += 2 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return sum / (4 * std::numbers::pi);
}

/// That the mesher can tell by both points where the lumen is, whatever cell it makes there.
void expectInside(const TriSurface& lumen, const FoamSettings& settings) {
  const LumenCase measured = measureLumen(lumen, settings);
  const NearestTriangle surface(lumen.vertices, lumen.triangles);
  const BackgroundBlock& block = measured.block;
  for (const Vec3& place : measured.inside) {
    EXPECT_NEAR(windingNumber(lumen, place), 1, 1e-6);
    const int finest = block.level + static_cast<int>(settings.strutLevel);
    for (int halvings = 0; halvings <= finest; ++halvings) {
      const Vec3 centre = block.cellCentre(place, halvings), edges = block.cell(halvings);
      for (int axis = 0; axis < 3; ++axis)
        EXPECT_LT(std::abs(std::abs(place[axis] - centre[axis]) / edges[axis] - 0.25), 0.249)
            << "on a face or in the middle between faces, axis " << axis;
      const bool surelyCut = surface.at(centre).distance < 0.5 * edges.minCoeff();
      if (halvings < finest && surelyCut) continue;
      EXPECT_NEAR(windingNumber(lumen, centre), 1, 1e-6) << "cells halved " << halvings << " times";
    }
  }
}

TEST(InsidePoint, everyCellThereHasItsCentreInsideHooksOfAnyLength) {
  const auto settings = FoamSettings::forFidelity("draft");
  for (int n = 0; n < 24; ++n)
    expectInside(hookTube(0.5e-3, 0.1e-3 + n * 0.011e-3, 1e-3, 0.3e-3, 48), settings);
}

TEST(InsidePoint, ofObliqueNarrowAndThinLumens) {
  const auto settings = FoamSettings::forFidelity("draft");
  for (const double radius : {0.06e-3, 0.1e-3, 0.2e-3, 0.9e-3}) {
    expectInside(tube(radius, vesselLength), settings);
    expectInside(moved(bentTube(radius, 1e-3, 2e-3, 1e-3), motionTo(Vec3(1, 2, 3), Vec3(1e-3, 0, 0))),
                 settings);
  }
  expectInside(annularTube(0.9e-3, 0.8e-3, vesselLength), settings);
  expectInside(stentedTube(0.3e-3, vesselLength, 0.09e-3), settings);
}

TEST(InsidePoint, aWideLumenLeavesACellOfTheCoreAroundBothPoints) {
  const auto settings = FoamSettings::forFidelity("draft");
  const TriSurface lumen = hookTube(vesselRadius, 1e-3, 2e-3, 1e-3);
  const NearestTriangle surface(lumen.vertices, lumen.triangles);
  const auto [first, second] = measureLumen(lumen, settings).inside;
  EXPECT_GT(surface.at(first).distance, settings.cellSize);
  EXPECT_GT(surface.at(second).distance, settings.cellSize);
  EXPECT_GT((first - second).norm(), settings.cellSize);
}

}  // namespace
}  // namespace restenosis

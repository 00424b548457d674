#include <gtest/gtest.h>

#include "bridge/compare/ComparedParts.h"
#include "tests/support/Constants.h"
#include "tests/support/FlowSupport.h"
#include "tests/support/TubeSurface.h"

namespace restenosis {
namespace {

using namespace support;

TEST(ComparedParts, followTheDistanceFromStrutsAndEnds) {
  const TriSurface lumen = stentedTube(vesselRadius, 2.0 * vesselLength, 90e-6);
  const auto faces = comparedFaces(lumen, {}, {.endLength = 0.15e-3, .strutReach = 0.4e-3});
  std::array<int, comparedParts.size()> found{};
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const Vec3 centre = lumen.centre(faces.triangle[i]);
    const double fromEnd = std::min(centre.z(), 2.0 * vesselLength - centre.z());
    const double fromStrut = std::abs(centre.z() - vesselLength) - 45e-6;
    ++found[static_cast<std::size_t>(faces.part[i])];
    if (faces.part[i] == ComparedPart::ends) {
      EXPECT_LT(fromEnd, 0.15e-3);
    }
    if (faces.part[i] == ComparedPart::strut) {
      EXPECT_LT(fromStrut, 1e-6);
    }
    if (faces.part[i] == ComparedPart::smoothWall) {
      EXPECT_GT(fromStrut, 0.3e-3);
    }
    if (faces.part[i] == ComparedPart::betweenStruts) {
      EXPECT_LT(fromStrut, 0.4e-3);
    }
  }
  for (const int count : found) EXPECT_GT(count, 0);
}

TEST(ComparedParts, withoutStrutsAllIsSmoothWallButTheEnds) {
  const TriSurface lumen = tube(vesselRadius, vesselLength);
  const auto faces = comparedFaces(lumen);
  double area = 0.0;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    EXPECT_TRUE(faces.part[i] == ComparedPart::smoothWall || faces.part[i] == ComparedPart::ends);
    area += faces.area[i];
  }
  EXPECT_NEAR(area / (2.0 * std::numbers::pi * vesselRadius * vesselLength), 1.0, 0.002);
}

TEST(ComparedParts, wallOverABuriedStrutIsNearAStrut) {
  // A ring of which only a quarter is buried, its middle 80 um outside of the wall.
  const TriSurface lumen = tube(vesselRadius, vesselLength);
  std::vector<Vec3> ring;
  const double outside = vesselRadius + 80e-6, middle = vesselLength / 2;
  for (double angle = 0; angle < std::numbers::pi / 2; angle += 0.02)
    ring.emplace_back(outside * std::cos(angle), outside * std::sin(angle), middle);
  const auto faces = comparedFaces(lumen, ring, {.endLength = 0.1e-3, .strutReach = 0.2e-3});
  int near = 0;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const Vec3 centre = lumen.centre(faces.triangle[i]);
    const double fromMiddle = std::abs(centre.z() - middle), angle = std::atan2(centre.y(), centre.x());
    const bool beside = fromMiddle < 0.18e-3 && angle > 0 && angle < std::numbers::pi / 2;
    const bool isNear = faces.part[i] == ComparedPart::betweenStruts;
    near += isNear;
    if (beside) {
      EXPECT_TRUE(isNear) << centre.transpose();
    }
    if (fromMiddle > 0.21e-3 || std::abs(angle) > 3) {
      EXPECT_FALSE(isNear) << centre.transpose();
    }
  }
  EXPECT_GT(near, 0);
}

}  // namespace
}  // namespace restenosis

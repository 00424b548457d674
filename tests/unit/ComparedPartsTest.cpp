#include <gtest/gtest.h>

#include "ComparedParts.h"
#include "FlowSupport.h"
#include "TubeSurface.h"

namespace restenosis {
namespace {

using namespace testing;

TEST(ComparedParts, followTheDistanceFromStrutsAndEnds) {
  const TriSurface lumen = stentedTube(vesselRadius, 2.0 * vesselLength, 90e-6);
  const auto faces = comparedFaces(lumen, {.endLength = 0.15e-3, .strutReach = 0.4e-3});
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

}  // namespace
}  // namespace restenosis

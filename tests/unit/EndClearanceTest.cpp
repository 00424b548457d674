#include <gtest/gtest.h>

#include "bridge/flow/EndClearance.h"
#include "tests/support/AnnularTube.h"
#include "tests/support/Constants.h"
#include "tests/support/HookTube.h"
#include "tests/support/TubeSurface.h"

namespace restenosis {
namespace {

using namespace support;

constexpr double clearanceDepth = 0.135e-3;

bool inTheWay(const TriSurface& lumen, SurfaceRegion end = SurfaceRegion::inlet) {
  return strangerNearEnd(lumen, end, clearanceDepth).has_value();
}

TEST(EndClearance, theEndsOwnWallIsNotInTheWay) {
  for (const SurfaceRegion end : {SurfaceRegion::inlet, SurfaceRegion::outlet}) {
    EXPECT_FALSE(inTheWay(tube(vesselRadius, vesselLength), end));
    EXPECT_FALSE(inTheWay(tube(vesselRadius, vesselLength, 1), end));
    EXPECT_FALSE(inTheWay(annularTube(0.9e-3, 0.5e-3, vesselLength), end));
    EXPECT_FALSE(inTheWay(bentTube(vesselRadius, 1e-3, 2e-3, 1e-3), end));
  }
}

TEST(EndClearance, aTaperedEndAndAStrutAtItAreNotInTheWay) {
  const auto tapered = [](double degrees) {
    const double wider = vesselRadius + 0.3e-3 * std::tan(degrees * std::numbers::pi / 180);
    return revolve({{vesselRadius, 0}, {wider, 0.3e-3}, {vesselRadius, 1.2e-3}});
  };
  EXPECT_FALSE(inTheWay(tapered(-45)));
  EXPECT_FALSE(inTheWay(tapered(45)));
  EXPECT_FALSE(inTheWay(tapered(60)));
  EXPECT_FALSE(inTheWay(revolve({{vesselRadius, 0},
                                 {vesselRadius, 0.02e-3, SurfaceRegion::strut},
                                 {vesselRadius - 0.09e-3, 0.02e-3, SurfaceRegion::strut},
                                 {vesselRadius - 0.09e-3, 0.11e-3, SurfaceRegion::strut},
                                 {vesselRadius, 0.11e-3},
                                 {vesselRadius, vesselLength}})));
}

TEST(EndClearance, theOtherEndInTheSamePlaneIsInTheWay) {
  const double bend = 1.3e-3;
  for (const double offset : {0.0, 1e-12, -1e-12, 1e-9, -1e-9, 0.1e-3, -0.1e-3}) {
    const TriSurface hook = hookTube(vesselRadius, 0.5e-3, bend, 0.5e-3 + offset);
    for (const SurfaceRegion end : {SurfaceRegion::inlet, SurfaceRegion::outlet}) {
      const auto place = strangerNearEnd(hook, end, clearanceDepth);
      ASSERT_TRUE(place) << offset;
      const double middle = end == SurfaceRegion::inlet ? 2 * bend : 0.0;
      EXPECT_LE(std::abs(place->x() - middle), 1.01 * vesselRadius) << "not of the other limb";
    }
  }
  EXPECT_FALSE(inTheWay(hookTube(vesselRadius, 0.5e-3, bend, 0.3e-3)));
  // Of limbs that all but touch, too
  EXPECT_TRUE(inTheWay(hookTube(vesselRadius, 0.5e-3, vesselRadius + 1e-6, 0.5e-3)));
}

TEST(EndClearance, theBendBeneathTheOutletIsInTheWay) {
  // A hook turned over: its arc comes down to the plane of the ends, beside them
  const auto dipping = [](double lowest) {
    std::vector<AxisPoint> axis;
    for (int i = 0; i <= 40; ++i) {
      const double x = 6e-3 * i / 40, phase = 2 * std::numbers::pi * i / 40;
      const double z = 0.5 * (2e-3 - lowest) * std::cos(2 * phase) + 0.5 * (2e-3 + lowest);
      const double slope = -(2e-3 - lowest) * 2 * std::numbers::pi / 6e-3 * std::sin(2 * phase);
      axis.push_back({Vec3(x, 0, z), Vec3(1, 0, slope).normalized()});
    }
    axis.insert(axis.begin(), {Vec3(-0.6e-3, 0, 1.4e-3), Vec3(0.7071067811865476, 0, 0.7071067811865476)});
    axis.insert(axis.begin(), {Vec3(-0.8e-3, 0, 0.0), Vec3::UnitZ()});
    return sweptTube(axis, 0.3e-3);
  };
  EXPECT_TRUE(inTheWay(dipping(0.3e-3)));
  EXPECT_TRUE(inTheWay(dipping(0.38e-3)));
  EXPECT_FALSE(inTheWay(dipping(0.6e-3)));
}

TEST(EndClearance, aShoulderInThePlaneIsInTheWay) {
  const auto shouldered = [](double height) {
    return revolve({{0.5e-3, 0}, {0.5e-3, height}, {1e-3, height}, {1e-3, 1e-3}, {0.5e-3, 2e-3}});
  };
  EXPECT_TRUE(inTheWay(shouldered(0.01e-3)));
  EXPECT_TRUE(inTheWay(shouldered(0.1e-3)));
  EXPECT_FALSE(inTheWay(shouldered(0.15e-3)));
  EXPECT_FALSE(inTheWay(shouldered(0.01e-3), SurfaceRegion::outlet));
}

}  // namespace
}  // namespace restenosis

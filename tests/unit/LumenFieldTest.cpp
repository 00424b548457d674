#include <gtest/gtest.h>

#include "bridge/surface/LumenField.h"
#include "bridge/surface/RadialMap.h"
#include "tests/support/Constants.h"
#include "tests/support/SphereWall.h"

namespace restenosis {
namespace {

using namespace support;

TEST(LumenField, NeedsTissueAndSoundSettings) {
  EXPECT_THROW(LumenField::fromTissue({}, std::span<const StrutSegment>(), 1e-3), std::invalid_argument);
  const AgentStore wall = sphereWall(100 * um, 100 * um, 15 * um);
  EXPECT_THROW(LumenField::fromTissue(wall, {}, 100 * um, {.smoothing = -1}), std::invalid_argument);
  EXPECT_THROW(LumenField::fromTissue(wall, {}, 100 * um, {.resolution = 0}), std::invalid_argument);
}

TEST(LumenField, OverlappingSpheresThatFormASmoothCylinderKeepItsRadius) {
  // Spheres every 6 um on a cylinder: their faces deviate from it by 0.3 um at most, so this is the
  // bias of the method itself: scallops of the closing, blur on a curved surface.
  const double lumen = 250 * um, length = 150 * um, r = 15 * um;
  AgentStore agents;
  for (int k = 0; k <= 25; ++k)
    for (int n = 0; n < 278; ++n) {
      const double angle = 2 * std::numbers::pi * n / 278;
      agents.append(AgentKind::iel,
                    {(lumen + r) * std::cos(angle), (lumen + r) * std::sin(angle), 6 * um * k}, r);
    }
  const RadialMap map(LumenField::fromTissue(agents, {}, length));
  EXPECT_NEAR(map.meanRadius(), lumen, 0.004 * lumen);
}

TEST(LumenField, IsOccludedByAPlugAndByALumenNarrowerThanTheBall) {
  AgentStore wall = sphereWall(100 * um, 300 * um, 15 * um);
  EXPECT_FALSE(LumenField::fromTissue(wall, {}, 300 * um).occluded());
  for (int i = -4; i <= 4; ++i)
    for (int j = -4; j <= 4; ++j) wall.append(AgentKind::smc, {i * 24 * um, j * 24 * um, 150 * um}, 15 * um);
  EXPECT_TRUE(LumenField::fromTissue(wall, {}, 300 * um).occluded());
  EXPECT_TRUE(LumenField::fromTissue(sphereWall(25 * um, 300 * um, 15 * um), {}, 300 * um).occluded());
}

TEST(LumenField, AHoleInTheWallIsNoWayOut) {
  AgentStore wall = sphereWall(150 * um, 300 * um, 15 * um, 1);
  std::vector<std::uint8_t> remove(wall.size(), 0);
  for (Index i = 0; i < wall.size(); ++i)
    remove[i] = wall.x[i] > 0 && std::abs(wall.y[i]) < 60 * um && std::abs(wall.z[i] - 150 * um) < 60 * um;
  wall.erase(remove);
  const RadialMap map(LumenField::fromTissue(wall, {}, 300 * um));
  for (int k = 0; k < map.planes(); ++k) EXPECT_LT(map.radius(k, 0), 166 * um);
}

TEST(LumenField, TheSpaceOutsideOfAnUnevenWallIsNoLumen) {
  AgentStore wall = sphereWall(100 * um, 300 * um, 15 * um);
  std::ranges::fill(wall.kind, AgentKind::eel);
  const auto area = [&] { return RadialMap(LumenField::fromTissue(wall, {}, 300 * um)).minimalArea(); };
  const double even = area();
  // One agent far out: between it and the wall there is more room than in the lumen
  wall.append(AgentKind::eel, {0, 250 * um, 150 * um}, 15 * um);
  EXPECT_NEAR(area(), even, 0.01 * even);

  // And none to flow through when the lumen is closed
  for (int i = -4; i <= 4; ++i)
    for (int j = -4; j <= 4; ++j) wall.append(AgentKind::smc, {i * 24 * um, j * 24 * um, 150 * um}, 15 * um);
  EXPECT_TRUE(LumenField::fromTissue(wall, {}, 300 * um).occluded());
}

TEST(LumenField, TakesStrutsGivenAsSpheres) {
  AgentStore wall = sphereWall(150 * um, 300 * um, 15 * um);
  for (int n = 0; n < 20; ++n)
    wall.append(AgentKind::strut, {80 * um, (n - 10) * 10 * um, 150 * um}, 20 * um);
  const LumenField field = LumenField::fromTissue(wall, {}, 300 * um);
  EXPECT_TRUE(field.isStrut({60 * um, 0, 150 * um}));
  EXPECT_FALSE(field.isStrut({-150 * um, 0, 150 * um}));
  EXPECT_NEAR(RadialMap(field, 4).radius(10, 0), 60 * um, 0.5 * um);
}

}  // namespace
}  // namespace restenosis

#include <gtest/gtest.h>

#include "tests/support/Constants.h"
#include "tissue/agents/RandomStream.h"
#include "tissue/vessel/Cylindrical.h"
#include "tissue/vessel/EndPlanes.h"
#include "tissue/vessel/LaminaSurfaces.h"
#include "tissue/vessel/OuterConfinement.h"

namespace restenosis {
namespace {

using namespace support;

class WallConstraints : public testing::Test {
 protected:
  Index add(AgentKind kind, const Vec3& place) { return agents.append(kind, place, r); }
  Vec3 projected(const Constraint& constraint, Index i) {
    Vec3 position = agents.position(i);
    constraint.project(agents.kind[i], agents.radius[i], position);
    return position;
  }
  Vec3 released(const Constraint& constraint, Index i, Vec3 force) {
    constraint.release(agents.kind[i], agents.radius[i], agents.position(i), force);
    return force;
  }
  AgentStore agents;
};

/// Laminae at 0.9 and 1.1 mm from the axis.
const WallShape shape = [] {
  VesselParameters vessel;
  vessel.lumenDiameter = 2 * (0.9e-3 - r);
  vessel.wallThickness = 0.2e-3 + 2 * r;
  vessel.cellRadius = r;
  return cylindricalShape(vessel);
}();

TEST_F(WallConstraints, LaminaSlidesOnItsCylinder) {
  const LaminaSurfaces cylinders(shape);
  const Index iel = add(AgentKind::iel, {0.5e-3, 0.5e-3, 1e-4});
  const Vec3 place = projected(cylinders, iel);
  EXPECT_NEAR(radiusOf(place), 0.9e-3, 1e-15);
  EXPECT_DOUBLE_EQ(place.x(), place.y());
  EXPECT_DOUBLE_EQ(place.z(), 1e-4);
  agents.setPosition(iel, {0.9e-3, 0, 0});
  EXPECT_EQ(released(cylinders, iel, {3, 2, 1}), Vec3(0, 2, 1));
}

TEST_F(WallConstraints, LaminaSlidesOnACone) {
  std::vector<double> radii(64, 1e-3);  // at z = 0; at z = 1 mm half as much again
  std::fill(radii.begin() + 32, radii.end(), 1.5e-3);
  const SurfaceFromAxis cone(RadiusMap(32, 0, 1e-3, radii));
  const WallShape conical{cone, cone, cone, cone, 0, 0, 0};
  const LaminaSurfaces surfaces(conical);
  const Index iel = add(AgentKind::iel, {2e-3, 0, 0.5e-3});
  EXPECT_NEAR(radiusOf(projected(surfaces, iel)), 1.25e-3, 1e-15);
  const Vec3 normal = Vec3(1, 0, -0.5).normalized(), along = Vec3(0.5, 0, 1).normalized();
  EXPECT_LT(released(surfaces, iel, 3 * normal).norm(), 1e-12) << "what presses it on is carried";
  EXPECT_LT((released(surfaces, iel, normal + along) - along).norm(), 1e-12);
}

TEST_F(WallConstraints, CellsStayBetweenTheLaminae) {
  const LaminaSurfaces cylinders(shape);
  const Index inside = add(AgentKind::smc, {0.8e-3, 0, 0}), between = add(AgentKind::smc, {1e-3, 0, 0}),
              outside = add(AgentKind::smc, {0, 1.2e-3, 0});
  EXPECT_NEAR(radiusOf(projected(cylinders, inside)), 0.9e-3 + r, 1e-15);
  EXPECT_EQ(projected(cylinders, between), Vec3(1e-3, 0, 0));
  EXPECT_NEAR(radiusOf(projected(cylinders, outside)), 1.1e-3 - r, 1e-15);
  // A cell at the limit loses only the force that presses it on.
  agents.setPosition(inside, projected(cylinders, inside));
  EXPECT_EQ(released(cylinders, inside, {-1, 1, 0}), Vec3(0, 1, 0));
  EXPECT_EQ(released(cylinders, inside, {1, 1, 0}), Vec3(1, 1, 0));
  EXPECT_EQ(released(cylinders, between, {-1, 1, 0}), Vec3(-1, 1, 0));
}

TEST_F(WallConstraints, EndPlanesHoldCentres) {
  const EndPlanes ends(1e-3);
  const Index low = add(AgentKind::smc, {1e-3, 0, -1e-6}), high = add(AgentKind::smc, {1e-3, 0, 1e-3});
  EXPECT_EQ(projected(ends, low), Vec3(1e-3, 0, 0));
  EXPECT_EQ(projected(ends, high), Vec3(1e-3, 0, 1e-3));
  EXPECT_EQ(released(ends, high, {1, 1, 1}), Vec3(1, 1, 0));
  EXPECT_EQ(released(ends, high, {1, 1, -1}), Vec3(1, 1, -1));
}

TEST_F(WallConstraints, CellsStayInsideTheEel) {
  for (int n = 0; n < 300; ++n) {
    for (int k = 0; k < 5; ++k) {
      add(AgentKind::eel, toCartesian({1e-3, 2 * std::numbers::pi * n / 300, 25e-6 * k}));
    }
  }
  const Index cell = add(AgentKind::smc, {1.05e-3, 0, 50e-6}), eel = 7;
  const OuterConfinement confinement(agents, r);
  EXPECT_NEAR(radiusOf(projected(confinement, cell)), 1e-3 - 0.5 * r, 1e-12);
  EXPECT_EQ(projected(confinement, eel), agents.position(eel));
  agents.setPosition(cell, projected(confinement, cell));
  EXPECT_EQ(released(confinement, cell, {1, 1, 0}), Vec3(0, 1, 0));
  EXPECT_EQ(released(confinement, cell, {-1, 1, 0}), Vec3(-1, 1, 0));
  agents.setPosition(cell, {0.95e-3, 0, 50e-6});
  EXPECT_EQ(projected(confinement, cell), agents.position(cell));
  EXPECT_EQ(released(confinement, cell, {1, 1, 0}), Vec3(1, 1, 0));
}

TEST_F(WallConstraints, DoNothingToThoseWhoHaveRoom) {
  for (int n = 0; n < 300; ++n) {
    const double around = 2 * pi * n / 300;
    for (int k = 0; k < 5; ++k)
      add(AgentKind::eel, toCartesian({1e-3 + 5e-5 * std::cos(around), around, 25e-6 * k}));
  }
  const OuterConfinement confinement(agents, r);
  const EndPlanes ends(1e-4);
  const LaminaSurfaces laminae(shape);
  for (const Constraint* constraint :
       {static_cast<const Constraint*>(&confinement), static_cast<const Constraint*>(&ends),
        static_cast<const Constraint*>(&laminae)}) {
    for (const AgentKind kind : {AgentKind::smc, AgentKind::iel, AgentKind::eel, AgentKind::strut}) {
      for (std::uint64_t n = 0; n < 500; ++n) {
        RandomStream random(1, n, 0, RandomPurpose::packing);
        const Vec3 from =
            toCartesian({1.1e-3 * random.uniform(), 2 * pi * random.uniform(), 1e-4 * random.uniform()});
        const double margin = std::min(1e-3, constraint->margin(kind, r, from));
        if (margin <= 0) continue;
        const Vec3 there = from + 0.999 * margin * random.direction();
        Vec3 place = there, force = random.direction();
        const Vec3 before = force;
        constraint->project(kind, r, place);
        constraint->release(kind, r, there, force);
        ASSERT_EQ(place, there);
        ASSERT_EQ(force, before);
      }
    }
  }
  const Vec3 middle(0.5e-3, 0, 0.5e-4), outside(1.1e-3, 0, 0.5e-4);
  EXPECT_NEAR(confinement.margin(AgentKind::smc, r, middle), 0.95e-3 - 0.5 * r - 0.5e-3, 5e-6);
  EXPECT_LT(confinement.margin(AgentKind::smc, r, outside), 0);
  EXPECT_EQ(confinement.margin(AgentKind::eel, r, outside), never);
  EXPECT_DOUBLE_EQ(ends.margin(AgentKind::smc, r, middle), 0.5e-4);
  EXPECT_EQ(laminae.margin(AgentKind::smc, r, middle), 0);
}

}  // namespace
}  // namespace restenosis

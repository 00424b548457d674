#include <gtest/gtest.h>

#include "tissue/agents/StateArchive.h"
#include "tissue/neighbours/NeighbourQuery.h"
#include "tissue/vessel/Cylindrical.h"
#include "tissue/vessel/WallPacking.h"

namespace restenosis {
namespace {

VesselParameters smallVessel() {
  VesselParameters vessel;
  vessel.length = 0.2e-3;
  vessel.lumenDiameter = 0.4e-3;
  return vessel;
}

template <class T>
std::string digest(T value) {
  HashingArchive archive;
  archive(value);
  return archive.digest();
}

TEST(WallPacking, CountsAreThoseOfTheModel) {
  VesselParameters vessel;  // the thesis vessel
  const AgentCounts counts = countAgents(vessel, cylindricalShape(vessel));
  EXPECT_NEAR(counts.total(), 248000, 500);
  EXPECT_NEAR(counts.iel, 0.82 * 2 * 0.915e-3 * 4.5e-3 / (15e-6 * 15e-6), 1);
  EXPECT_NEAR(counts.eel, 0.82 * 2 * 1.085e-3 * 4.5e-3 / (15e-6 * 15e-6), 1);
  vessel.length = 1.2e-3;
  EXPECT_NEAR(countAgents(vessel, cylindricalShape(vessel)).total(), 66100, 100);
}

TEST(WallPacking, AWallTooThinIsRefusedWithTheKeysToChange) {
  VesselParameters vessel = smallVessel();
  vessel.wallThickness = 50e-6;
  try {
    countAgents(vessel, cylindricalShape(vessel));
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("vessel.wallThickness"), std::string::npos);
  }
}

TEST(WallPacking, ScatterPutsAgentsWhereTheyBelong) {
  const VesselParameters vessel = smallVessel();
  const Wall wall = scatterWall(vessel, cylindricalShape(vessel), 1);
  const AgentCounts counts = countAgents(vessel, cylindricalShape(vessel));
  ASSERT_EQ(wall.agents.size(), counts.total());
  for (Index i = 0; i < wall.agents.size(); ++i) {
    const double radius = radiusOf(wall.agents.position(i));
    ASSERT_GE(wall.agents.z[i], 0);
    ASSERT_LE(wall.agents.z[i], vessel.length);
    switch (wall.agents.kind[i]) {
      case AgentKind::iel:
        ASSERT_NEAR(radius, 0.215e-3, 1e-12);
        break;
      case AgentKind::eel:
        ASSERT_NEAR(radius, 0.385e-3, 1e-12);
        break;
      default:
        ASSERT_GE(radius, 0.230e-3);
        ASSERT_LE(radius, 0.370e-3);
    }
  }
}

TEST(WallPacking, ScatterKeepsAgentsApart) {
  const Wall wall = scatterWall(smallVessel(), cylindricalShape(smallVessel()), 1);
  const CellGrid grid(wall.agents, 30e-6);
  NeighbourQuery query(wall.agents, grid);
  double nearest = 1;
  for (Index i = 0; i < wall.agents.size(); ++i) {
    query.forEachNeighbour(i, 1, [&](Index, double distance) { nearest = std::min(nearest, distance); });
  }
  EXPECT_GT(nearest / 30e-6, 0.7);  // 0.82 to begin with, lowered only where a lamina is full
}

TEST(WallPacking, ScatterIsAFunctionOfTheSeed) {
  EXPECT_EQ(digest(scatterWall(smallVessel(), cylindricalShape(smallVessel()), 1)),
            digest(scatterWall(smallVessel(), cylindricalShape(smallVessel()), 1)));
  EXPECT_NE(digest(scatterWall(smallVessel(), cylindricalShape(smallVessel()), 1)),
            digest(scatterWall(smallVessel(), cylindricalShape(smallVessel()), 2)));
}

TEST(WallPacking, RadiiHaveTheirSpreadAndTheWallItsVolume) {
  VesselParameters vessel = smallVessel();
  vessel.radiusSpread = 0.1;
  const Wall wall = scatterWall(vessel, cylindricalShape(vessel), 1);
  const double n = wall.agents.size();
  double sum = 0, squares = 0, volume = 0;
  for (Index i = 0; i < wall.agents.size(); ++i) {
    const double r = wall.agents.radius[i];
    sum += r, squares += r * r, volume += 4.0 / 3 * std::numbers::pi * r * r * r;
    ASSERT_LE(std::abs(r / 15e-6 - 1), 0.3 + 1e-12);
  }
  const double mean = sum / n, deviation = std::sqrt(squares / n - mean * mean);
  EXPECT_NEAR(mean / 15e-6, 1, 5 * 0.1 / std::sqrt(n));
  EXPECT_NEAR(deviation / 15e-6, 0.1,
              0.1 * (5 / std::sqrt(2 * n) + 0.015));  // cut at three deviations: -1.3 %
  const double wallVolume = std::numbers::pi * (0.4e-3 * 0.4e-3 - 0.2e-3 * 0.2e-3) * 0.2e-3;
  EXPECT_NEAR(volume / wallVolume, 0.62, 0.62 * 5 * 0.3 / std::sqrt(n));
}

TEST(WallPacking, EndsAreFixedToTheStatedDepth) {
  Wall wall = scatterWall(smallVessel(), cylindricalShape(smallVessel()), 1);
  fixEnds(wall, 2);
  for (Index i = 0; i < wall.agents.size(); ++i) {
    const bool nearEnd = std::min(wall.agents.z[i], 0.2e-3 - wall.agents.z[i]) < 30e-6;
    EXPECT_EQ(wall.agents.has(i, fixed), nearEnd);
  }
}

TEST(WallPacking, ALoadedWallIsBondedAndKeepsItsPlaces) {
  const VesselParameters vessel = smallVessel();
  const AgentStore agents = scatterWall(vessel, cylindricalShape(vessel), 1).agents;
  const Wall wall = adoptWall(vessel, agents);
  ASSERT_EQ(wall.agents.size(), agents.size());
  EXPECT_GT(wall.bonds.bondCount(), agents.size());
  for (Index i = 0; i < wall.agents.size(); ++i) {
    ASSERT_EQ(wall.agents.position(i), agents.position(static_cast<Index>(wall.agents.id[i])));
  }
}

TEST(WallPacking, CanBeGivenUpAtAnyMoment) {
  const VesselParameters vessel = smallVessel();
  struct GivenUp {};
  int calls = 0;
  const auto pack = [&](int until) {
    calls = 0;
    return packWall(vessel, cylindricalShape(vessel), {}, {}, 1, nullptr, [&] {
      if (++calls == until) throw GivenUp();
    });
  };
  const std::string whole = digest(packWall(vessel, {}, {}, 1).agents);
  EXPECT_EQ(digest(pack(-1).agents), whole);
  const int all = calls;
  EXPECT_GT(all, 20);
  for (const int moment : {1, 2, all / 2, all}) EXPECT_THROW(pack(moment), GivenUp) << moment;
}

}  // namespace
}  // namespace restenosis

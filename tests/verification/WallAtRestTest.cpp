#include <gtest/gtest.h>
#include <omp.h>

#include <array>
#include <complex>

#include "tissue/agents/StateArchive.h"
#include "tissue/neighbours/NeighbourQuery.h"
#include "tissue/vessel/Cylindrical.h"
#include "tissue/vessel/EndPlanes.h"
#include "tissue/vessel/OuterConfinement.h"
#include "tissue/vessel/RadiusMap.h"
#include "tissue/vessel/WallPacking.h"

namespace restenosis {
namespace {

VesselParameters vessel() {
  VesselParameters parameters;
  parameters.length = 0.3e-3;
  parameters.lumenDiameter = 0.6e-3;
  return parameters;
}

struct Packed {
  Packed() { wall = packWall(vessel(), {}, {}, 1, &report); }
  Wall wall;
  PackingReport report;
};

const Packed& packed() {
  static const Packed instance;
  return instance;
}

TEST(WallAtRest, LaminaeStayOnTheirCylindersWhenReleased) {
  EXPECT_TRUE(packed().report.packed.converged);
  EXPECT_TRUE(packed().report.released.converged);
  EXPECT_LT(std::abs(packed().report.ielDrift), 0.1e-6);
  EXPECT_EQ(packed().report.expelled, 0u);
}

TEST(WallAtRest, ATighterRelaxationMovesNothingFar) {
  Wall wall = packed().wall;
  RelaxationParameters tight;
  tight.tolerance = 1e-4;
  const OuterConfinement outside(wall.agents, wall.cellRadius);
  const EndPlanes ends(wall.length);
  const std::array<const Constraint*, 2> constraints = {&outside, &ends};
  Relaxation({}, tight, wall.cellRadius).relax(wall.agents, wall.bonds, constraints);
  double squares = 0, drift = 0;
  Index iel = 0;
  for (Index i = 0; i < wall.agents.size(); ++i) {
    squares += (wall.agents.position(i) - packed().wall.agents.position(i)).squaredNorm();
    if (wall.agents.kind[i] != AgentKind::iel) continue;
    drift += radiusOf(wall.agents.position(i)) - radiusOf(packed().wall.agents.position(i)), ++iel;
  }
  EXPECT_LT(std::abs(drift / iel), 0.1e-6);
  EXPECT_LT(std::sqrt(squares / wall.agents.size()), 0.5e-6);
}

TEST(WallAtRest, NobodyLeavesThroughTheEnds) {
  for (const double z : packed().wall.agents.z) {
    ASSERT_GE(z, 0);
    ASSERT_LE(z, vessel().length);
  }
}

/// Near the ends agents line up along the end planes.
bool nearEnd(Index i) {
  const double z = packed().wall.agents.z[i];
  return std::min(z, vessel().length - z) < 60e-6;
}

/// Neighbours within 1.5 (R1 + R2): mid-wall 14.6 +- 1.2, IEL 10.3 +- 0.9 in the trial of the wall's packing.
TEST(WallAtRest, CellsHaveTheNeighboursOfADensePacking) {
  const AgentStore& agents = packed().wall.agents;
  const CellGrid grid(agents, 45e-6);
  NeighbourQuery query(agents, grid);
  double middle = 0, iel = 0;
  int middleCount = 0, ielCount = 0;
  for (Index i = 0; i < agents.size(); ++i) {
    if (nearEnd(i)) continue;
    int neighbours = 0;
    query.forEachNeighbour(i, 1.5, [&](Index, double) { ++neighbours; });
    const double radius = radiusOf(agents.position(i));
    if (agents.kind[i] == AgentKind::iel) iel += neighbours, ++ielCount;
    if (radius > 0.36e-3 && radius < 0.44e-3) middle += neighbours, ++middleCount;
  }
  EXPECT_NEAR(middle / middleCount, 14.6, 0.6);
  EXPECT_NEAR(iel / ielCount, 10.3, 0.6);
}

/// A dense sheet of equal spheres has six-fold order around each agent (0.6 here; 1 in a lattice). In rows
/// the whole sheet would share one direction and have the same order; in a random sheet patches point
/// anywhere, and the order of n patches averages to 1/sqrt(n) of it.
TEST(WallAtRest, TheLaminaeHaveNoRows) {
  const AgentStore& agents = packed().wall.agents;
  const CellGrid grid(agents, 45e-6);
  NeighbourQuery query(agents, grid);
  for (const AgentKind lamina : {AgentKind::iel, AgentKind::eel}) {
    std::complex<double> wholeSum = 0;
    double localSum = 0;
    int pairs = 0, centres = 0;
    for (Index i = 0; i < agents.size(); ++i) {
      if (agents.kind[i] != lamina || nearEnd(i)) continue;
      const Cylindrical a = toCylindrical(agents.position(i));
      std::complex<double> own = 0;
      int ownPairs = 0;
      query.forEachNeighbour(i, 1.1, [&](Index j, double) {
        if (agents.kind[j] != lamina) return;
        const Cylindrical b = toCylindrical(agents.position(j));
        const double around = a.radius * std::remainder(b.angle - a.angle, 2 * std::numbers::pi);
        own += std::polar(1.0, 6 * std::atan2(b.z - a.z, around));
        ++ownPairs;
      });
      if (ownPairs == 0) continue;
      wholeSum += own, pairs += ownPairs;
      localSum += std::abs(own) / ownPairs, ++centres;
    }
    EXPECT_LT(std::abs(wholeSum) / pairs, 0.4 * localSum / centres);
  }
}

TEST(WallAtRest, IsTheSameForAnyNumberOfThreads) {
  VesselParameters small = vessel();
  small.length = 0.1e-3, small.lumenDiameter = 0.3e-3;
  const auto digestWith = [&](int threads) {
    omp_set_num_threads(threads);
    Wall wall = packWall(small, {}, {}, 1);
    HashingArchive archive;
    archive(wall);
    return archive.digest();
  };
  const int before = omp_get_max_threads();
  const std::string one = digestWith(1), three = digestWith(3);
  omp_set_num_threads(before);
  EXPECT_EQ(one, three);
}

TEST(WallAtRest, SpreadRadiiPackAsWell) {
  VesselParameters spread = vessel();
  spread.radiusSpread = 0.1;
  PackingReport report;
  packWall(spread, {}, {}, 1, &report);
  EXPECT_TRUE(report.released.converged);
  EXPECT_LT(std::abs(report.ielDrift), 0.1e-6);
  EXPECT_EQ(report.expelled, 0u);
}

}  // namespace
}  // namespace restenosis

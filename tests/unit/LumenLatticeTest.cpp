#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "bridge/flow/lbm/LumenLattice.h"
#include "tests/support/TubeSurface.h"

namespace restenosis {
namespace {

using namespace support;

TEST(LumenLattice, holdsAboutTheVolumeInNodes) {
  const double radius = 10.3, length = 12.0;
  const auto lattice = makeLumenLattice(tube(radius, length), 1.0);
  EXPECT_EQ(lattice.frame.size[2], 12);
  EXPECT_NEAR(lattice.layout.fluidNodes() / (std::numbers::pi * radius * radius * length), 1.0, 0.03);
}

TEST(LumenLattice, spacingFitsTheLength) {
  const auto lattice = makeLumenLattice(tube(10.3, 12.3), 1.0);
  EXPECT_NEAR(lattice.frame.dx * lattice.frame.size[2], 12.3, 1e-12);
}

TEST(LumenLattice, linksEndOnTheSurface) {
  const double radius = 10.3, length = 6.0;
  const TriSurface surface = tube(radius, length);
  const auto lattice = makeLumenLattice(surface, 1.0);
  int wall = 0, ends = 0;
  for (const SurfaceLink& link : lattice.links) {
    const auto& c = d3q19::c[link.direction];
    const Vec3 at =
        lattice.frame.position(link.coordinates) + link.q * lattice.frame.dx * Vec3(c[0], c[1], c[2]);
    if (surface.region[link.triangle] == SurfaceRegion::wall) {
      EXPECT_NEAR(at.head<2>().norm(), radius, 0.005);
      ++wall;
    } else {
      EXPECT_NEAR(std::min(std::abs(at.z()), std::abs(at.z() - length)), 0.0, 1e-4);
      EXPECT_NEAR(link.q, 0.5, 1e-4);
      ++ends;
    }
    EXPECT_FALSE(link.bothFluid);
  }
  EXPECT_GT(wall, 1000);
  EXPECT_GT(ends, 1000);
}

TEST(LumenLattice, runsCoverEveryNodeOnce) {
  const auto lattice = makeLumenLattice(stentedTube(9.0, 12.0, 2.0), 1.0);
  std::size_t nodes = 0;
  std::uint32_t end = 0;
  for (const NodeRun& run : lattice.layout.runs()) {
    EXPECT_GE(run.first, end);
    end = run.first + run.count;
    nodes += run.count;
    EXPECT_EQ(lattice.layout.place(run.x, run.y, run.z), run.first);
  }
  EXPECT_EQ(nodes, lattice.layout.fluidNodes());
}

TEST(LumenLattice, refusesWhatItCannotResolve) {
  EXPECT_THROW(makeLumenLattice(tube(10.3, 12.0), 1.0, 100.0), std::invalid_argument);
  EXPECT_THROW(makeLumenLattice(tube(10.3, 12.0), std::numeric_limits<double>::quiet_NaN()),
               std::invalid_argument);
  EXPECT_THROW(makeLumenLattice(tube(10.3, 12.0), 0.0), std::invalid_argument);
  TriSurface open = tube(10.3, 12.0);
  open.triangles.pop_back();
  open.region.pop_back();
  EXPECT_THROW(makeLumenLattice(open, 1.0), std::invalid_argument);
}

}  // namespace
}  // namespace restenosis

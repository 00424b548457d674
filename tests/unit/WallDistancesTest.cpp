#include <gtest/gtest.h>

#include "bridge/flow/lbm/WallDistances.h"
#include "tests/support/LatticeSupport.h"
#include "tests/support/TubeSurface.h"

namespace restenosis {
namespace {

using namespace support;

TEST(WallDistances, AreThoseFromTheWallNotFromTheEnds) {
  constexpr double radius = 0.5e-3, length = 0.4e-3;
  const TriSurface surface = tube(radius, length);
  const LumenLattice lattice = makeLumenLattice(surface, 50e-6);
  const auto position = placePositions(lattice);
  const Vec3 place(0.2e-3, 0.1e-3, 0.1e-3);
  std::vector<NearNode> nodes;
  for (const NodeRun& run : lattice.layout.runs())
    for (std::uint32_t n = run.first; n < run.first + run.count; ++n)
      nodes.push_back({n, (position[n] - place) / lattice.frame.dx, 1.0});

  WallDistances distances(surface, lattice);
  distances.add(place, nodes);
  distances.add(place, nodes);
  distances.find();
  distances.set(nodes);
  ASSERT_FALSE(nodes.empty());
  // The wall is a polygon: its middle of a side is nearer than its corner
  for (const NearNode& n : nodes)
    EXPECT_NEAR(n.wallDistance * lattice.frame.dx, radius - position[n.place].head<2>().norm(),
                2e-3 * radius);
}

}  // namespace
}  // namespace restenosis

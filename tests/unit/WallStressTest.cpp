#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/LatticeSupport.h"

namespace restenosis {
namespace {

using namespace support;

TEST(WallStress, AdaptiveTakesTheRuleThatSuitsThePlace) {
  constexpr double radius = 8.0, length = 24.0, ring = 4.0;
  const TriSurface lumen = stentedTube(radius, length, ring);
  const LumenLattice lattice = makeLumenLattice(lumen, 1.0);
  LatticeEnds ends;
  ends.inlet = LatticeEnds::Inlet::pressure;
  LatticeFlow<double> flow(lattice.layout, makeBoundary(lattice, lumen.region, WallRule::interpolated, ends),
                           {});
  flow.initialise([](std::uint32_t place) {
    NodeState s;
    s.velocity = 0.02 * Vec3(std::sin(0.7 * place), std::cos(0.2 * place), 1.0);
    s.stress = {1e-4 * std::sin(0.3 * place), -3e-4, 2e-4, 5e-5, -6e-5, 7e-5};
    return s;
  });

  struct Stresses {
    Stresses(const TriSurface& surface, const LumenLattice& nodes, const LatticeFlowBase& solved,
             StressRule rule)
        : faces(WallStress(surface, nodes, rule, 0.1)), wall(faces.wall(faces.nodeValues(solved), 1.0)) {}
    WallStress faces;
    std::vector<WallFace> wall;
  };
  const Stresses adaptive(lumen, lattice, flow, StressRule::adaptive);
  const Stresses fitted(lumen, lattice, flow, StressRule::fitted);
  const Stresses ratio(lumen, lattice, flow, StressRule::ratio);
  const Stresses gradient(lumen, lattice, flow, StressRule::gradient);
  const auto off = [](const WallFace& a, const WallFace& b) {
    return (a.traction - b.traction).norm() / b.traction.norm();
  };
  int smooth = 0, rough = 0, struts = 0;
  for (std::size_t f = 0; f < adaptive.wall.size(); ++f) {
    const WallFace& face = adaptive.wall[f];
    const double fromRing = std::abs(face.centre.z() - length / 2) - ring / 2;
    if (fromRing > 4.0) {  // no edge within three spacings of the face's centre
      EXPECT_LT(off(face, fitted.wall[f]), 1e-9) << face.centre.transpose();
      ++smooth;
    } else if (face.region == SurfaceRegion::strut) {
      EXPECT_LT(off(face, gradient.wall[f]), 1e-9) << face.centre.transpose();
      ++struts;
    } else if (fromRing < 1.0) {
      EXPECT_LT(off(face, ratio.wall[f]), 1e-9) << face.centre.transpose();
      ++rough;
    }
  }
  EXPECT_GT(smooth, 100);
  EXPECT_GT(rough, 100);
  EXPECT_GT(struts, 100);
}

TEST(WallStress, LongTrianglesAreSampledInPieces) {
  const TriSurface lumen = tube(8.0, 48.0, 1);
  const LumenLattice lattice = makeLumenLattice(lumen, 1.0);
  const WallStress faces(lumen, lattice, StressRule::fitted, 0.1);
  LatticeEnds ends;
  ends.inlet = LatticeEnds::Inlet::pressure;
  const LatticeFlow<double> still(lattice.layout,
                                  makeBoundary(lattice, lumen.region, WallRule::interpolated, ends), {});
  double area = 0, low = 48, high = 0;
  for (const WallFace& face : faces.wall(faces.nodeValues(still), 1.0)) {
    area += face.area;
    low = std::min(low, face.centre.z()), high = std::max(high, face.centre.z());
  }
  double whole = 0;
  for (std::size_t t = 0; t < lumen.triangles.size(); ++t)
    if (lumen.region[t] == SurfaceRegion::wall) whole += lumen.areaVector(t).norm();
  EXPECT_NEAR(area / whole, 1, 1e-12);
  EXPECT_LT(low, 2.5) << "a triangle's centre is 16 spacings from its ends";
  EXPECT_GT(high, 45.5);
}

}  // namespace
}  // namespace restenosis

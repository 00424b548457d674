// Cost and WSS error of the fidelity levels, on a plain tube and with one strut ring. Prints a table.
#include <gtest/gtest.h>

#include "bridge/flow/foam/FoamBackend.h"
#include "tests/support/Constants.h"
#include "tests/support/FlowSupport.h"
#include "tests/support/OpenFoamPresent.h"
#include "tests/support/TemporaryFolder.h"
#include "tests/support/TubeSurface.h"

namespace restenosis::support {
namespace {

using namespace support;

double meanStress(const FlowSolution& s, SurfaceRegion region) {
  double sum = 0.0, area = 0.0;
  for (const auto& f : s.wall)
    if (f.region == region) sum += f.area * f.traction.norm(), area += f.area;
  return area > 0.0 ? sum / area : 0.0;
}

/// The largest L2 error of the stress in a plain tube that each fidelity is meant to have.
double l2Limit(std::string_view level) {
  if (level == "reference") return 0.01;
  return level == "standard" ? 0.02 : 0.025;
}

TEST(FoamFidelity, costAndError) {
  RESTENOSIS_NEEDS_OPENFOAM();
  std::printf(
      "level      lumen     cells  it  mesh_s solve_s  mean_%%   L2_%%  max_%%  wall_Pa strut_Pa  dp_Pa   "
      "imbalance remarks\n");
  for (const char* level : {"draft", "standard", "reference"})
    for (const bool stented : {false, true}) {
      const TemporaryFolder folder;
      FoamBackend backend(FoamSettings::forFidelity(level));
      const auto lumen =
          stented ? stentedTube(vesselRadius, vesselLength, 90e-6) : tube(vesselRadius, vesselLength);
      const auto s = backend.solve(lumen, vesselConditions(), folder.path() / "case");
      // Undisturbed part: the middle of the plain tube; upstream of the ring in the other
      const auto e = stented ? stressError(s, vesselStress(), 0.1e-3, 0.25e-3)
                             : stressError(s, vesselStress(), 0.1e-3, 1.1e-3);
      std::printf("%-10s %-8s %7zu %3d %7.2f %7.2f %7.2f %6.2f %6.2f %8.4f %8.4f %6.3f  %.1e %zu\n", level,
                  stented ? "stented" : "tube", s.cells, s.iterations, s.meshSeconds, s.solveSeconds,
                  100 * e.mean, 100 * e.l2, 100 * e.maximum, meanStress(s, SurfaceRegion::wall),
                  meanStress(s, SurfaceRegion::strut), s.pressureDrop, s.massImbalance, s.remarks.size());
      for (double z = 0; z < 1.15e-3; z += 0.1e-3) {
        const auto p = stressError(s, vesselStress(), z, z + 0.1e-3);
        std::printf("  %.2f:%+.1f", z * 1e3, 100 * p.mean);
      }
      std::printf("\n");
      std::fflush(stdout);
      if (!stented) {
        EXPECT_LE(e.l2, l2Limit(level));
      }
    }
}

}  // namespace
}  // namespace restenosis::support

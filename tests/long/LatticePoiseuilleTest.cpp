#include <gtest/gtest.h>

#include "tests/support/LatticeSupport.h"

namespace restenosis {
namespace {

using namespace support;

/// Prints the table of docs/results/verification.md: a periodic tube along the lattice.
TEST(LatticePoiseuilleLong, table) {
  struct Row {
    const char* name;
    WallRule wall;
    double tau;
    bool single;
  };
  std::printf("%-34s%6s%14s%14s%14s%12s%12s%12s%12s\n", "wall, collision (tau)", "D", "velocity [%]",
              "WSS mean [%]", "WSS rms [%]", "ratio mean", "ratio [%]", "gradient [%]", "nearest [%]");
  for (const Row& row : {Row{"interpolated, TRT (1.0)", WallRule::interpolated, 1.0, false},
                         Row{"interpolated, TRT (0.6)", WallRule::interpolated, 0.6, false},
                         Row{"interpolated, BGK (0.6)", WallRule::interpolated, 0.6, true},
                         Row{"bounce-back, TRT (1.0)", WallRule::bounceBack, 1.0, false},
                         Row{"bounce-back, BGK (0.6)", WallRule::bounceBack, 0.6, true}})
    for (const double diameter : {15.0, 30.0, 60.0}) {
      LatticeRelaxation relaxation;
      relaxation.tau = row.tau;
      relaxation.single = row.single;
      const auto e = periodicTube(diameter, row.wall, relaxation);
      std::printf("%-34s%6.0f%14.4f%14.4f%14.4f%12.3f%12.3f%12.3f%12.3f\n", row.name, diameter,
                  100 * e.velocity, 100 * e.stressMean, 100 * e.stressRms, 100 * e.ratioMean,
                  100 * e.ratioRms, 100 * e.gradientRms, 100 * e.nearestRms);
      if (row.wall == WallRule::interpolated && !row.single && diameter == 60) {
        EXPECT_LT(e.velocity, 0.001);
        EXPECT_LT(e.stressRms, 0.005);
      }
    }
}

}  // namespace
}  // namespace restenosis

#include <gtest/gtest.h>

#include "tests/support/LbmCases.h"

namespace restenosis {
namespace {

using namespace support;

void record(const std::string& name, double value) {
  ::testing::Test::RecordProperty(name, std::to_string(value));
}

void show(const std::string& name, const StressError& e) {
  std::printf("%-40s WSS mean %8.3f %%  rms %7.3f %%  largest %7.3f %%\n", name.c_str(), 100 * e.mean,
              100 * e.l2, 100 * e.maximum);
  record(name + " rms", e.l2);
}

TEST(LbmBackendLong, turnedTubesAtSixtyNodesAcross) {
  for (const double degrees : {17.0, 45.0}) {
    const auto coarse = turnedTubeError(degrees, 30), fine = turnedTubeError(degrees, 60);
    show(std::to_string(degrees) + " degrees, D = 30", coarse);
    show(std::to_string(degrees) + " degrees, D = 60", fine);
    show(std::to_string(degrees) + " degrees, D = 60, bounce-back",
         turnedTubeError(degrees, 60, "bounceBack", "nearest"));
    EXPECT_LT(fine.l2, 0.02);
    EXPECT_LT(fine.l2, coarse.l2);
  }
}

TEST(LbmBackendLong, ellipticDuctAndItsOrder) {
  const auto coarse = ellipticDuctError(24), fine = ellipticDuctError(48);
  show("ellipse, 24 nodes along its long axis", coarse.stress);
  show("ellipse, 48 nodes along its long axis", fine.stress);
  std::printf("velocity %.3f %%, %.3f %%; pressure drop %.3f %%, %.3f %%\n", 100 * coarse.velocity,
              100 * fine.velocity, 100 * coarse.pressureDrop, 100 * fine.pressureDrop);
  EXPECT_LT(fine.stress.l2, 0.01);
  EXPECT_GT(std::log2(coarse.stress.l2 / fine.stress.l2), 1.0);
}

}  // namespace
}  // namespace restenosis

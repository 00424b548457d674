#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/LatticeSupport.h"

namespace restenosis {
namespace {

using namespace support;

LatticeRelaxation relaxed(double tau, bool single = false) {
  LatticeRelaxation r;
  r.tau = tau;
  r.single = single;
  return r;
}

TEST(LatticePoiseuille, thirtyAndSixtyNodesAcrossAndTheOrder) {
  const auto coarse = periodicTube(30, WallRule::interpolated, relaxed(1.0));
  const auto fine = periodicTube(60, WallRule::interpolated, relaxed(1.0));
  EXPECT_LT(coarse.velocity, 0.003);
  EXPECT_LT(coarse.stressRms, 0.01);
  EXPECT_LT(fine.velocity, 0.001);
  EXPECT_LT(fine.stressRms, 0.005);
  EXPECT_GT(std::log2(coarse.velocity / fine.velocity), 1.7);
}

TEST(LatticePoiseuille, oneRelaxationTimeAndSinglePrecision) {
  EXPECT_LT(periodicTube(30, WallRule::interpolated, relaxed(0.6, true)).stressRms, 0.015);
  const auto e = periodicTube<float>(30, WallRule::interpolated, relaxed(1.0));
  EXPECT_LT(e.velocity, 0.003);
  EXPECT_LT(e.stressRms, 0.01);
}

TEST(LatticePoiseuille, bounceBackWithTheNearestNodesStressIsOffByTenPerCentAndMore) {
  const auto e = periodicTube(30, WallRule::bounceBack, relaxed(1.0));
  EXPECT_GT(e.nearestRms, 0.1);
  EXPECT_LT(e.nearestRms, 0.3);
}

}  // namespace
}  // namespace restenosis

#include <gtest/gtest.h>

#include "bridge/output/ThicknessMapCsv.h"
#include "tests/support/TemporaryFolder.h"

namespace restenosis {
namespace {

TEST(ThicknessMapCsv, HasARowForEachRayInTheUnitsItNames) {
  TemporaryFolder folder;
  const auto round = [](double radius) {
    return RadialMap::ofRound([radius](double z) { return radius - 0.01 * z; }, 1e-3, 1e-3, 4);
  };
  writeThicknessMapCsv(folder / "map.csv", round(1e-3), round(0.9e-3));
  EXPECT_EQ(readText(folder / "map.csv"),
            "z_mm,angle_deg,lumenRadius_um,neointimaThickness_um\n"
            "0,0,900,100\n0,90,900,100\n0,180,900,100\n0,270,900,100\n"
            "0.5,0,895,100\n0.5,90,895,100\n0.5,180,895,100\n0.5,270,895,100\n"
            "1,0,890,100\n1,90,890,100\n1,180,890,100\n1,270,890,100\n");
}

}  // namespace
}  // namespace restenosis

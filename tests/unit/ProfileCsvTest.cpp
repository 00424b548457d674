#include <gtest/gtest.h>

#include <array>

#include "bridge/output/ProfileCsv.h"
#include "tests/support/TemporaryFolder.h"

namespace restenosis {
namespace {

TEST(ProfileCsv, WritesTheContractsColumnsInTheirUnits) {
  TemporaryFolder folder;
  const std::array rows{ProfileRow{0.5e-3, 2.5e-6, 0.125, 40e-6}, ProfileRow{1e-3, 2e-6, {}, {}}};
  writeProfileCsv(folder / "profile.csv", rows);
  EXPECT_EQ(readText(folder / "profile.csv"),
            "z_mm,lumenArea_mm2,neointimaAreaFraction,neointimaThickness_um\n0.5,2.5,0.125,40\n1,2,,\n");
}

}  // namespace
}  // namespace restenosis

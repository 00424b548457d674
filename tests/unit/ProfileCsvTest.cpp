#include <gtest/gtest.h>

#include <array>

#include "bridge/output/ProfileCsv.h"
#include "tests/support/TemporaryFolder.h"

namespace restenosis {
namespace {

TEST(ProfileCsv, WritesTheContractsColumnsInTheirUnits) {
  TemporaryFolder folder;
  HistologySection section{.intimaArea = 0.5e-6, .mediaArea = 1e-6, .relativeIntimaArea = 0.25};
  section.intimaCells = 8, section.intimaCellsInCycle = 2;
  section.intimaVolume = 4, section.intimaMatrix = 3;
  const std::array rows{ProfileRow{0.5e-3, 2.5e-6, 0.125, 40e-6, section, true},
                        ProfileRow{0.7e-3, 2.5e-6, 0.125, 40e-6, section, false},
                        ProfileRow{1e-3, 2e-6, {}, {}, {}, false}};
  writeProfileCsv(folder / "profile.csv", rows);
  EXPECT_EQ(readText(folder / "profile.csv"),
            "z_mm,lumenArea_mm2,neointimaAreaFraction,neointimaThickness_um,intimaArea_mm2,mediaArea_mm2,"
            "relativeIntimaArea,intimaCells,intimaInCycle,intimaMatrixShare\n"
            "0.5,2.5,0.125,40,0.5,1,0.25,8,0.25,0.75\n"
            "0.7,2.5,0.125,40,0.5,1,0.25,8,0.25,\n"
            "1,2,,,,,,,,\n");
}

}  // namespace
}  // namespace restenosis

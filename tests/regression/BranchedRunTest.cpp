#include "tests/support/ExpectSays.h"
#include "tests/support/OpenFoamPresent.h"
#include "tests/support/WholeProgram.h"

namespace restenosis {
namespace {

/// The scene `patient` with large cells.
class BranchedRun : public WholeProgram {
 protected:
  BranchedRun() {
    const std::filesystem::path scenes = RESTENOSIS_SOURCE_DIR "/scenes";
    for (const char* file : {"patient.toml", "patient.stl", "patientOutlets.csv"})
      std::filesystem::copy(scenes / file, folder / file);
  }
  ProcessEnd runWith(const std::string& command, const std::vector<std::string>& settings) const {
    std::vector<std::string> arguments{command, "patient.toml"};
    if (command == "run")
      arguments.insert(arguments.end(),
                       {"-o", "out", "--set", "foam.cellSize=0.5 mm", "--set", "output.pictures=false"});
    for (const std::string& setting : settings) arguments.insert(arguments.end(), {"--set", setting});
    return run(arguments);
  }
};

TEST_F(BranchedRun, SharesOutTheFlow) {
  RESTENOSIS_NEEDS_OPENFOAM();
  ASSERT_EXIT_STATUS(runWith("run", {}), 0);
  const auto outlets = summary("out")["flow"]["outlets"];
  ASSERT_EQ(outlets.size(), 3U);
  EXPECT_EQ(outlets[2]["solid"], "outlet_diagonal");
  EXPECT_NEAR(outlets[2]["share"], 0.123, 1e-3);
  EXPECT_EQ(outlets[0]["pressure_Pa"], 0);
  EXPECT_EQ(summary("out")["remarks"].size(), 0U) << summary("out")["remarks"];
}

TEST_F(BranchedRun, FindsTheFlowThatResistancesLetThrough) {
  RESTENOSIS_NEEDS_OPENFOAM();
  // As small as that of the artery itself, so that it counts
  writeText(folder / "patientOutlets.csv",
            "solid,resistance\noutlet_diagonal,4e8\noutlet_circumflex,1e8\noutlet_anterior_descending,1e8\n");
  ASSERT_EXIT_STATUS(runWith("run", {}), 0);
  const auto outlets = summary("out")["flow"]["outlets"];
  const auto atEnd = [&](int n) {
    const double resistances[] = {1e8, 1e8, 4e8};
    return outlets[n]["pressure_Pa"].get<double>() -
           resistances[n] * outlets[n]["flowRate_m3_s"].get<double>();
  };
  const double bed = -atEnd(0);
  EXPECT_NEAR((atEnd(1) - atEnd(0)) / bed, 0, 0.02);
  EXPECT_NEAR((atEnd(2) - atEnd(0)) / bed, 0, 0.02);
}

TEST_F(BranchedRun, WhatCannotBeSolvedIsRefused) {
  const auto expectRefused = [&](const std::vector<std::string>& settings, const std::string& says) {
    const ProcessEnd end = runWith("check", settings);
    EXPECT_EXIT_STATUS(end, 2);
    EXPECT_SAYS(end.err, says);
  };
  expectRefused({"flow.backend=lbm"}, "'outlets' in [flow] cannot be solved by backend = \"lbm\"");
  expectRefused({"flow.drive=pressureGradient"}, "shares out a flow rate");
  expectRefused({"flow.waveform=coronaryLeft"}, "shares out a steady flow");
  expectRefused({"flow.crossCheck=lbm"}, "leaves nothing to compare with");
  expectRefused({"flow.outlets=\"\""}, "separate pieces");
  expectRefused({"mechanics=present"}, "around which no tissue is grown");
  writeText(folder / "patientOutlets.csv", "solid,share\noutlet_diagonal,0.5\noutlet_other,0.5\n");
  expectRefused({}, "the table names the outlets outlet_diagonal, outlet_other, but 'lumenSurface' has");
  writeText(folder / "patientOutlets.csv", "solid,share\noutlet_diagonal,0.5\n");
  expectRefused({}, "holds 1 outlets");
  const ProcessEnd compared = run({"compare", "patient.toml", "-o", "compared"});
  EXPECT_EXIT_STATUS(compared, 2);
}

}  // namespace
}  // namespace restenosis

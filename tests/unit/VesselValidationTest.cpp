#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "tissue/stent/StentValidation.h"

namespace restenosis {
namespace {

class Validate : public testing::Test {
 protected:
  /// The keys of all problems, in one line.
  std::string keys() const {
    std::string all;
    for (const ParameterProblem& problem : validate(vessel, &stent)) {
      EXPECT_FALSE(problem.message.empty());
      all += problem.key + " ";
    }
    return all;
  }
  VesselParameters vessel;
  StentParameters stent;
};

TEST_F(Validate, DefaultsAreFine) {
  for (const char* design : {"ring", "rings", "ringsWithLinks", "helix", "biodivysio"}) {
    stent.design = design;
    EXPECT_EQ(keys(), "") << design;
  }
  EXPECT_TRUE(validate(vessel, nullptr).empty());
}

TEST_F(Validate, StentLongerThanTheVessel) {
  stent.design = "rings";
  stent.length = 5e-3;
  EXPECT_EQ(keys(), "stent.length ");
  EXPECT_EQ(validate(vessel, &stent)[0].message,
            "a stent of 5 mm is longer than the vessel (4.5 mm); allowed is at most vessel.length");
  stent.design = "ring";  // a single ring does not read the length
  EXPECT_EQ(keys(), "");
}

TEST_F(Validate, StrutThickerThanTheLumen) {
  stent.strutThickness = 1e-3;
  EXPECT_EQ(keys(), "stent.strutThickness ");
}

TEST_F(Validate, StrutWiderThanTheVessel) {
  vessel.length = 0.08e-3;
  EXPECT_EQ(keys(), "stent.strutWidth ");
}

TEST_F(Validate, StentShorterThanAStrutIsWide) {
  for (const char* design : {"ring", "rings", "ringsWithLinks", "helix", "biodivysio"}) {
    stent.design = design;
    stent.length = 0.05e-3;
    stent.ringCount = 1;
    stent.linkCount = 1;
    EXPECT_NE(keys(), "") << design;
  }
  stent.design = "ring";
  EXPECT_EQ(validate(vessel, &stent)[0].message,
            "a stent of 0.05 mm is shorter than its ring, a strut 0.09 mm wide (stent.strutWidth); allowed "
            "is at least that");
  stent.length = stent.strutWidth;
  EXPECT_EQ(keys(), "");
}

TEST_F(Validate, SaysNothingByWhatIsNotKnown) {
  stent.design = "helix";
  stent.length = 5e-3;
  stent.helixTurns = 99;
  stent.strutThickness = 1e-3;
  stent.deploymentDepth = 1e-3;
  const auto keysWithout = [this](std::string_view unknown) {
    std::string all;
    for (const auto& problem : validate(vessel, &stent, [&](std::string_view key) { return key != unknown; }))
      all += problem.key + " ";
    return all;
  };
  EXPECT_EQ(keysWithout(""), "stent.deploymentDepth stent.strutThickness stent.length stent.helixTurns ");
  EXPECT_EQ(keysWithout("stent.length"), "stent.deploymentDepth stent.strutThickness ");
  EXPECT_EQ(keysWithout("stent.design"), "stent.deploymentDepth stent.strutThickness ");
  EXPECT_EQ(keysWithout("vessel.length"), "stent.deploymentDepth stent.strutThickness stent.helixTurns ");
  EXPECT_EQ(keysWithout("vessel.lumenDiameter"), "stent.deploymentDepth stent.length stent.helixTurns ");
  EXPECT_EQ(keysWithout("vessel.cellRadius"), "stent.strutThickness stent.length stent.helixTurns ");
  vessel.agents = "/nowhere.csv";
  EXPECT_EQ(keysWithout("vessel.agents"), keysWithout("").substr(std::string("vessel.agents ").size()));
}

TEST_F(Validate, DepthBeyondTheWall) {
  stent.deploymentDepth = 180e-6;
  EXPECT_EQ(keys(), "stent.deploymentDepth ");
}

TEST_F(Validate, LayoutThatOverlaps) {
  stent.design = "rings";
  stent.ringCount = 50;
  EXPECT_EQ(keys(), "stent.ringCount ");
  stent.design = "helix";
  stent.helixTurns = 50;
  EXPECT_EQ(keys(), "stent.helixTurns ");
  stent.design = "biodivysio";
  stent.ringCount = 7;
  stent.linkCount = 9;
  EXPECT_EQ(keys(), "stent.linkCount ");
}

TEST_F(Validate, WallTooThinForItsCellsAndVesselShorterThanItsEnds) {
  vessel.wallThickness = 40e-6;
  stent.deploymentDepth = 0;
  EXPECT_EQ(keys(), "vessel.wallThickness ");
  vessel = VesselParameters();
  vessel.length = 50e-6;
  stent.strutWidth = 20e-6;
  EXPECT_EQ(keys(), "vessel.length ");
}

TEST_F(Validate, TablesThatCannotBeUsed) {
  const auto file = std::filesystem::temp_directory_path() / ("strut-" + std::to_string(getpid()) + ".csv");
  vessel.agents = "/nowhere.csv";
  EXPECT_EQ(keys(), "vessel.agents ");
  std::ofstream(file) << "x,y,z,radius\n900,0,9000,15\n";
  vessel.agents = file.string();
  EXPECT_EQ(keys(), "vessel.agents ");
  std::ofstream(file) << "x,y,z,radius\n900,0,90,15\n";
  EXPECT_EQ(keys(), "vessel.agents ");  // no wall around the stent
  EXPECT_TRUE(validate(vessel, nullptr).empty());
  vessel.lumenSurface = "lumen.stl";
  EXPECT_EQ(keys(), "vessel.lumenSurface vessel.agents ");
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace restenosis

#include <gtest/gtest.h>

#include "tests/support/TemporaryFolder.h"
#include "tissue/stent/StrutAgents.h"
#include "tissue/stent/StrutFit.h"
#include "tissue/vessel/Cylindrical.h"

namespace restenosis {
namespace {

/// Tables of spheres for a lumen of radius 250 um.
class StrutFitTest : public testing::Test {
 protected:
  StrutFitTest() {
    vessel.length = 0.2e-3;
    vessel.lumenDiameter = 0.5e-3;
    vessel.wallThickness = 0.12e-3;
    file = (folder.path() / "st.csv").string();
  }
  AgentTable struts() const { return readAgentTable(file, AgentKind::strut); }
  /// What is said of three spheres that fit and these rows, or "accepted".
  std::string finding(const std::string& rows, const std::string& header = "x,y,z,radius\n") const {
    const char* kind = header.find("kind") != std::string::npos ? ",strut" : "";
    std::string text = header;
    for (const char* row : {"230,0,100,20", "0,230,100,20", "-230,0,100,20"})
      text += row + std::string(kind) + '\n';
    writeText(file, text + rows);
    try {
      outwardsToLumen(struts(), vessel);
      return "accepted";
    } catch (const TableError& error) {
      const std::string message = error.what();
      EXPECT_TRUE(message.starts_with(file)) << message;
      return message.substr(file.size());
    }
  }

  TemporaryFolder folder;
  VesselParameters vessel;
  std::string file;
};

#define EXPECT_SAID(text, beginning) EXPECT_TRUE((text).starts_with(beginning)) << (text)

TEST_F(StrutFitTest, SpheresThatFitAreMovedToTheLumen) {
  EXPECT_EQ(finding("0,-200,100,30\n"), "accepted");
  EXPECT_EQ(finding("0,-240,100,20,strut\n", "x,y,z,radius,kind\n"), "accepted");
  const Stent placed = stentOfSpheres(struts(), vessel);
  ASSERT_EQ(placed.spheres.size(), 4u);
  EXPECT_NEAR(radiusOf(placed.centre(3)), 230e-6, 1e-15);
  EXPECT_NEAR(radiusOf(placed.centre(0)), 220e-6, 1e-15);
}

TEST_F(StrutFitTest, ACrimpedStentIsTaken) {
  writeText(file, "x,y,z,radius\n60,0,100,10\n0,55,100,10\n-60,0,100,10\n");
  EXPECT_NEAR(outwardsToLumen(struts(), vessel), 180e-6, 1e-15);
}

TEST_F(StrutFitTest, ASphereThatDoesNotFitIsNamed) {
  const std::pair<const char*, const char*> cases[] = {
      {"0,-2300,100,20\n",
       ":5: the sphere lies 2300 um from the axis (x = y = 0); allowed are at most 555 um"},
      {"1e300,0,100,20\n", ":5: the sphere lies 1e+300 um from the axis"},
      {"0,0,100,20\n", ":5: the sphere lies over the axis (x = y = 0): its centre is 0 um from it"},
      {"0.23,0,0.1,0.02\n", ":5: a radius of 0.02 um; allowed are 1 to 125 um"},
      {"0,-230,100,2000\n", ":5: a radius of 2000 um"},
      {"0,-230,100,1e300\n", ":5: a radius of 1e+300 um"},
      {"0,-230,201,20\n", ":5: the sphere at z = 201 um lies outside the vessel; allowed are 0 to 200 um"},
      {"0,-230,-1,20\n", ":5: the sphere at z = -1 um lies outside the vessel"}};
  for (const auto& [row, message] : cases) EXPECT_SAID(finding(row), message);
}

TEST_F(StrutFitTest, SpheresFarInsideOfTheOutermostAreRefused) {
  EXPECT_SAID(finding("0,-100,100,20\n"),
              ":5: the sphere lies 150 um further in than the outermost one (line 2) "
              "reaches");
  EXPECT_SAID(finding("0,-400,100,20\n"),
              ":2: the sphere lies 190 um further in than the outermost one (line 5) "
              "reaches, which is put at the lumen's surface; allowed are at most 125 um");
}

TEST_F(StrutFitTest, TheThickestSphereAllowedTouchesItsBound) {
  writeText(file, "x,y,z,radius\n300,0,100,125\n");
  EXPECT_NEAR(outwardsToLumen(struts(), vessel), -175e-6, 1e-15);
}

TEST_F(StrutFitTest, StrutsOnly) {
  EXPECT_SAID(finding("0,-230,100,20,smc\n", "x,y,z,radius,kind\n"), ":5: the kind is not strut");
  EXPECT_SAID(finding("0,-230,100,20,sturt\n", "x,y,z,radius,kind\n"),
              ":5: unknown kind 'sturt'; did you mean 'strut'? Allowed: strut; the column may be left out");
}

TEST_F(StrutFitTest, NoTwoSpheresAreAtOnePlace) {
  EXPECT_SAID(finding("0,230,100,20\n"), ":5: the agent is at the place of the one in line 3; no two may be");
  EXPECT_SAID(finding("0,-230,100,20\n0,-230.00001,100,15\n"), ":6: the agent is at the place of the one");
  EXPECT_EQ(finding("0,-230,100,20\n0,-230.1,100,20\n"), "accepted") << "spheres may overlap";
}

}  // namespace
}  // namespace restenosis

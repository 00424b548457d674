#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "tests/support/FourLayers.h"
#include "tests/support/TemporaryFolder.h"
#include "tissue/vessel/WallTable.h"

namespace restenosis {
namespace {

/// Tables of a wall of four layers in a vessel that it fits.
class WallTable : public testing::Test {
 protected:
  WallTable() {
    vessel.length = 0.2e-3;
    vessel.lumenDiameter = 0.5e-3;
    vessel.wallThickness = 0.12e-3;
    vessel.agents = (folder.path() / "w.csv").string();
  }
  static std::string wall(double scale = 1, double shift = 0) { return fourLayers(scale, shift); }
  /// What is said of a table after the name of its file, or "accepted".
  std::string finding(const std::string& text, std::optional<double> deploymentDepth = {}) const {
    writeText(vessel.agents, text);
    try {
      readWallTable(vessel, deploymentDepth);
      return "accepted";
    } catch (const TableError& error) {
      const std::string message = error.what();
      EXPECT_TRUE(message.starts_with(vessel.agents)) << message;
      return message.substr(vessel.agents.size());
    }
  }
  static std::size_t lines(const std::string& text) { return std::ranges::count(text, '\n'); }

  TemporaryFolder folder;
  VesselParameters vessel;
  static constexpr double depth = 60e-6;
};

#define EXPECT_FINDING(text, beginning) EXPECT_TRUE((text).starts_with(beginning)) << (text)

TEST_F(WallTable, AWallThatFitsIsTaken) {
  EXPECT_EQ(finding(wall()), "accepted");
  EXPECT_EQ(finding(wall(), depth), "accepted");
  EXPECT_EQ(readWallTable(vessel, depth).size(), lines(wall()) - 1);
}

TEST_F(WallTable, DeformedWallsAndStrutsWithoutAStentAreTaken) {
  EXPECT_EQ(finding(wall() + "0,0,100,15,smc\n240,0,100,7.5,strut\n"), "accepted");
  EXPECT_EQ(finding(wall() + "500,0,100,21,eel\n-295,10,-10,15,smc\n295,10,214,15,smc\n"), "accepted");
  EXPECT_EQ(finding(wall(1, 100)), "accepted");
}

TEST_F(WallTable, CellsAndIelOutsideTheEelAreNamed) {
  const std::string line = fmt::format(":{}: an agent of kind ", lines(wall()) + 1);
  EXPECT_FINDING(finding(wall() + "0,380,100,15,smc\n0,400,90,15,smc\n"),
                 line +
                     "smc outside the EEL: its centre is 380 um from the axis (x = y = 0), the EEL there 355 "
                     "um, which no cell leaves through; allowed are at most 370 um");
  EXPECT_FINDING(finding(wall() + "-375,0,100,15,iel\n"), line + "iel outside the EEL");
  EXPECT_EQ(finding(wall() + "0,368,100,15,smc\n"), "accepted");
  EXPECT_EQ(finding(wall() + "0,375,100,25,smc\n"), "accepted") << "a larger cell";
  EXPECT_EQ(finding(wall() + "0,380,100,15,strut\n"), "accepted");
  // IEL and EEL exchanged
  std::string exchanged = wall();
  for (std::size_t at = 0; (at = exchanged.find("el\n", at + 1)) != std::string::npos;)
    exchanged[at - 1] = exchanged[at - 1] == 'i' ? 'e' : 'i';
  EXPECT_NE(finding(exchanged).find("an agent of kind smc outside the EEL"), std::string::npos);
  // Where the EEL has no agents, nobody knows where it is
  std::string bare = "x,y,z,radius,kind\n", rows = wall();
  for (std::size_t begin = rows.find('\n') + 1, end; begin < rows.size(); begin = end + 1) {
    end = rows.find('\n', begin);
    const std::string row = rows.substr(begin, end - begin);
    if (!row.ends_with("eel") || !row.starts_with('-')) bare += row + '\n';
  }
  EXPECT_EQ(finding(bare + "-400,0,100,15,smc\n"), "accepted");
  EXPECT_NE(finding(bare + "400,0,100,15,smc\n"), "accepted");
}

TEST_F(WallTable, AFewCellsAreATissueToo) {
  EXPECT_EQ(finding("x,y,z,radius\n300,0,100,15\n"), "accepted");
  EXPECT_FINDING(finding("x,y,z,radius\n300,0,100,15\n", depth), ": no agent stands between 45 and 90 deg");
}

TEST_F(WallTable, StrutsAloneAreNoWall) {
  EXPECT_FINDING(finding("x,y,z,radius,kind\n260,0,100,15,strut\n"), ": has struts only");
}

TEST_F(WallTable, AnotherUnitIsToldByTheRadius) {
  for (const auto& [scale, shown] : {std::pair(1e-6, "1.5e-05"), {1e-3, "0.015"}, {1e3, "15000"}}) {
    EXPECT_FINDING(finding(wall(scale)), fmt::format(":2: a radius of {} um; allowed are 1.5 to 150 um, a "
                                                     "tenth to ten times vessel.cellRadius",
                                                     shown));
  }
}

TEST_F(WallTable, OneRowThatIsMisplacedIsNamed) {
  const std::string line = fmt::format(":{}: ", lines(wall()) + 1);
  const std::pair<const char*, const char*> cases[] = {
      {"5000,0,100,15,smc\n", "the agent lies 5000 um from the axis (x = y = 0); allowed are at most 555 um"},
      {"1e300,0,100,15,smc\n", "the agent lies 1e+300 um from the axis"},
      {"295,0,100000,15,smc\n",
       "the agent at z = 100000 um lies outside the vessel; allowed are 0 to 200 um"},
      {"-295,0,-50,15,smc\n", "the agent at z = -50 um lies outside the vessel"},
      {"295,10,100,200,smc\n", "a radius of 200 um; allowed are 1.5 to 150 um"},
      {"295,10,100,100000,smc\n", "a radius of 100000 um"},
      {"295,10,100,1e-300,smc\n", "a radius of 1e-300 um"}};
  for (const auto& [row, message] : cases) {
    EXPECT_FINDING(finding(wall() + row + "9000,0,0,15,smc\n"), line + message);
  }
}

TEST_F(WallTable, TwoAgentsAtOnePlaceAreNamed) {
  const std::string line =
      fmt::format(":{}: the agent is at the place of the one in line ", lines(wall()) + 2);
  const std::string own = wall() + "300,11,90,15,smc\n";
  EXPECT_FINDING(finding(own + "300,11,90,15,smc\n300,11,90,15,smc\n"),
                 line + fmt::format("{};", lines(own)));
  EXPECT_FINDING(finding(own + "300.00001,11,90.00001,15,smc\n"), line + fmt::format("{};", lines(own)));
  EXPECT_EQ(finding(own + "300.0001,11,90,15,smc\n"), "accepted");
}

TEST_F(WallTable, AWallThatIsNotAboutTheAxisIsRefused) {
  EXPECT_FINDING(finding(wall(1, 400)), ":2: the agent lies 665 um from the axis");
  vessel.lumenDiameter = 1e-3;  // so wide that every row lies within its bounds
  EXPECT_FINDING(finding(wall(1, 400)),
                 ": no agent stands between 90 and 135 degrees about the axis (x = y = 0)");
}

TEST_F(WallTable, ExchangedColumnsAreRefused) {
  std::string text = wall();
  text.replace(0, 5, "z,y,x");
  EXPECT_FINDING(finding(text), ":2: the agent at z = 265 um lies outside the vessel");
}

TEST_F(WallTable, AWallTooSmallForTheVesselIsRefused) {
  vessel.lumenDiameter = 1.8e-3;
  EXPECT_NE(
      finding(wall()).find("the outermost agent reaches 370 um from the axis, but the wall in [vessel] has "
                           "an outer radius of 1020 um"),
      std::string::npos)
      << finding(wall());
  vessel.lumenDiameter = 0.5e-3;
  vessel.length = 1.2e-3;
  EXPECT_FINDING(finding(wall()), ": no agent stands between z = 194 and 1200 um");
}

TEST_F(WallTable, AWallThatIsHeldAtOneEndOnlyIsRemarkedOn) {
  writeText(vessel.agents, wall());
  const AgentStore agents = readWallTable(vessel, {});
  EXPECT_EQ(remarkOnOpenEnds(vessel, agents), "");
  vessel.length = 0.25e-3;
  EXPECT_NE(remarkOnOpenEnds(vessel, agents).find("stands between z = 5 and 194 um of a vessel of 250 um"),
            std::string::npos)
      << remarkOnOpenEnds(vessel, agents);
  vessel.fixedEnds = 0;
  EXPECT_EQ(remarkOnOpenEnds(vessel, agents), "");
  vessel.fixedEnds = 2;
  AgentStore cells;
  cells.append(AgentKind::smc, {300e-6, 0, 100e-6}, 15e-6);
  EXPECT_EQ(remarkOnOpenEnds(vessel, cells), "");
}

TEST_F(WallTable, AStentOutsideOfTheWallIsRefused) {
  vessel.lumenDiameter = 0.9e-3;
  EXPECT_EQ(finding(wall()), "accepted");
  EXPECT_FINDING(finding(wall(), depth),
                 ": between 0 and 45 degrees about the axis (x = y = 0) the wall "
                 "reaches 370 um, but the stent 510 um");
}

TEST_F(WallTable, StrutsBesideAStentAreRefused) {
  EXPECT_FINDING(finding(wall() + "240,0,100,7.5,strut\n", depth),
                 fmt::format(":{}: a strut in the wall of a scene with [stent]", lines(wall()) + 1));
}

}  // namespace
}  // namespace restenosis

// Walls from a table, as users start them.
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkXMLPolyDataReader.h>

#include <cmath>

#include "tests/support/FourLayers.h"
#include "tests/support/WholeProgram.h"

namespace restenosis {
namespace {

constexpr std::string_view sceneOfTable = R"([scene]
duration = "2 h"
step = "1 h"
[vessel]
length = "0.2 mm"
lumenDiameter = "0.5 mm"
wallThickness = "0.12 mm"
agents = "wall.csv"
[injury]
[mechanics]
[cellCycle]
[output]
pictures = false
)";

class LoadedWall : public WholeProgram {
 protected:
  void writeWall() const { writeText(folder / "wall.csv", fourLayers()); }
  /// What summary.json says of a run with these settings.
  nlohmann::json after(const std::vector<std::string>& settings) const {
    std::vector<std::string> arguments = {"run", scene("table", sceneOfTable), "-o", "out"};
    for (const std::string& setting : settings) arguments.insert(arguments.end(), {"--set", setting});
    EXPECT_EXIT_STATUS(run(arguments), 0);
    return summary("out");
  }
  static bool tells(const nlohmann::json& json, const std::string& text) {
    return std::ranges::any_of(json["remarks"], [&](const nlohmann::json& remark) {
      return remark.get<std::string>().find(text) != std::string::npos;
    });
  }
  double largestRadius() const {
    const auto reader = vtkSmartPointer<vtkXMLPolyDataReader>::New();
    reader->SetFileName((folder / "out/tissue/tissue_000072.vtp").c_str());
    reader->Update();
    return reader->GetOutput()->GetPointData()->GetArray("radius")->GetRange()[1];
  }
};

TEST_F(LoadedWall, BreaksByTheStressThatItIsLoadedWith) {
  writeWall();
  const std::vector<std::string> byStress = {"injury.ielBreaks=true", "injury.strainLimitAround=100",
                                             "injury.strainLimitAlong=100",
                                             "injury.fenestrationProbability=0", "injury.endMargin=0 um"};
  auto firm = byStress, weak = byStress;
  firm.push_back("injury.stressLimit=1000 MPa");
  weak.push_back("injury.stressLimit=0.001 MPa");
  const auto unbroken = after(firm), broken = after(weak);
  EXPECT_EQ(unbroken["injury"]["brokenIelAgents"], 0);
  EXPECT_TRUE(tells(unbroken, "nor is its stress past injury.stressLimit")) << unbroken["remarks"];
  EXPECT_GT(broken["injury"]["brokenIelAgents"], 100);
  EXPECT_GT(broken["injury"]["syntheticCells"], 100);
}

TEST_F(LoadedWall, ThatEndsBeforeTheVesselDoesIsRemarkedOn) {
  writeWall();
  const std::string what = "stands between z = 5 and 194 um of a vessel of 250 um (vessel.length)";
  EXPECT_TRUE(tells(after({"vessel.length=0.25 mm"}), what));
  EXPECT_FALSE(tells(after({}), "stands between"));
  const std::string plan = run({"check", "table.toml", "--set", "vessel.length=0.25 mm"}).out;
  EXPECT_NE(plan.find(what), std::string::npos) << plan;
}

TEST_F(LoadedWall, GrowsItsCellsToTwiceTheVolumeOfTheirBirth) {
  const std::vector<std::string> growing = {"scene.duration=3 d", "injury.synthetic=all",
                                            "vessel.fixedEnds=0"};
  writeText(folder / "wall.csv", "x,y,z,radius,birthRadius\n300,0,100,18,15\n");
  after(growing);
  EXPECT_LT(largestRadius(), 15.01e-6 * std::cbrt(2.0));
  writeText(folder / "wall.csv", "x,y,z,radius\n300,0,100,18\n");
  after(growing);
  EXPECT_GT(largestRadius(), 17.99e-6);
}

TEST_F(LoadedWall, PressedDeeperThanItsContactLawHoldsForIsRemarkedOnOnce) {
  writeText(folder / "wall.csv", "x,y,z,radius\n300,0,100,100\n363,0,100,5\n");
  const auto json = after({"injury=absent", "vessel.wallThickness=0.4 mm"});
  EXPECT_TRUE(tells(json, "on day 0 2 of 2 agents are pressed deeper than the contact law holds for"))
      << json["remarks"];
  EXPECT_EQ(json["remarks"].size(), 1u) << json["remarks"];
}

}  // namespace
}  // namespace restenosis

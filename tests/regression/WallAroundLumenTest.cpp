// Tissue around a lumen from a file, as users start it.
#include <numbers>

#include "bridge/surface/StlFile.h"
#include "tests/support/FlowSupport.h"
#include "tests/support/TubeSurface.h"
#include "tests/support/WholeProgram.h"

namespace restenosis {
namespace {

using namespace support;

class WallAroundLumen : public WholeProgram {
 protected:
  /// Runs the tiny scene around this lumen.
  ProcessEnd runAround(const TriSurface& lumen, const std::string& out, std::vector<std::string> more = {}) {
    writeStl(folder / "lumen.stl", lumen, 1e-3);
    const std::string around = with(with(tinyScene, "length = \"0.24 mm\"", "lumenSurface = \"lumen.stl\""),
                                    "lumenDiameter = \"0.4 mm\"", "");
    std::vector<std::string> arguments = {"run", scene("around", around), "-o", out};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }
};

TEST_F(WallAroundLumen, OfACylinderGrowsAsTheVesselDoes) {
  ASSERT_EXIT_STATUS(run({"run", scene("tiny", tinyScene), "-o", "vessel"}), 0);
  ASSERT_EXIT_STATUS(runAround(tube(0.2e-3, 0.24e-3), "file"), 0);
  const auto vessel = summary("vessel"), file = summary("file");
  EXPECT_NEAR(double(file["agents"]) / double(vessel["agents"]), 1, 0.1);
  EXPECT_NEAR(file["deployment"]["ielRadiusUnderStruts_um"],
              double(vessel["deployment"]["ielRadiusUnderStruts_um"]), 3);
  EXPECT_EQ(file["deployment"]["cellsOutsideEel"], 0);
  EXPECT_GT(file["flow"]["solvesDone"], 0);
  const CsvColumns a(folder / "vessel/timeSeries.csv"), b(folder / "file/timeSeries.csv");
  EXPECT_NEAR(*b.values.at("smc").front() / *a.values.at("smc").front(), 1, 0.02);
  EXPECT_NEAR(*b.values.at("minLumenArea_mm2").front() / *a.values.at("minLumenArea_mm2").front(), 1, 0.02);
  EXPECT_GT(*b.values.at("divisions").back(), 0.5 * *a.values.at("divisions").back());
  EXPECT_LT(*b.values.at("divisions").back(), 2 * *a.values.at("divisions").back());
}

TEST_F(WallAroundLumen, OfAnEllipseLeavesIt) {
  TriSurface oval = tube(0.2e-3, 0.24e-3);
  for (Vec3& vertex : oval.vertices) vertex.x() *= 1.4;
  ASSERT_EXIT_STATUS(
      runAround(oval, "out",
                {"--set", "stent=absent", "--set", "injury=absent", "--set", "scene.duration=2 h"}),
      0);
  const double area = 1.4 * std::numbers::pi * 0.2 * 0.2;
  const CsvColumns series(folder / "out/timeSeries.csv");
  EXPECT_NEAR(*series.values.at("minLumenArea_mm2").front() / area, 1, 0.03);
}

TEST_F(WallAroundLumen, IsResumedToTheSameBits) {
  const TriSurface lumen = tube(0.2e-3, 0.24e-3);
  ASSERT_EXIT_STATUS(runAround(lumen, "whole", {"--threads", "1", "--set", "scene.duration=1 d"}), 0);
  ASSERT_EXIT_STATUS(runAround(lumen, "parts", {"--threads", "1", "--set", "scene.duration=0.5 d"}), 0);
  ASSERT_EXIT_STATUS(runAround(lumen, "parts", {"--threads", "2", "--set", "scene.duration=1 d", "--resume"}),
                     0);
  EXPECT_EQ(summary("parts")["stateDigest"], summary("whole")["stateDigest"]);
}

TEST_F(WallAroundLumen, IsRefusedWhereTheStentWouldBeginInTheWall) {
  std::vector<ProfilePoint> profile;
  for (int i = 0; i <= 12; ++i) profile.push_back({0.2e-3 - (i == 6 ? 60e-6 : 0), 0.02e-3 * i});
  const ProcessEnd end = runAround(revolve(profile), "out");
  EXPECT_EXIT_STATUS(end, 2);
  EXPECT_NE(end.err.find("'lumenDiameter' in [vessel]: the stent is put to the radius of 0.2"),
            std::string::npos)
      << end.err;
  EXPECT_FALSE(exists("out"));
}

TEST_F(WallAroundLumen, IsRefusedWhereTheAxisDoesNotSeeTheLumen) {
  TriSurface bow = tube(0.2e-3, 1.2e-3, 60);
  for (Vec3& vertex : bow.vertices)
    vertex.x() += 0.15e-3 * (1 - std::cos(2 * std::numbers::pi * vertex.z() / 1.2e-3));
  const ProcessEnd end = runAround(bow, "out");
  EXPECT_EXIT_STATUS(end, 2);
  EXPECT_NE(end.err.find("'lumenSurface' in [vessel]"), std::string::npos) << end.err;
  EXPECT_NE(end.err.find("along the axis it is not in the lumen"), std::string::npos) << end.err;
  EXPECT_FALSE(exists("out"));
}

}  // namespace
}  // namespace restenosis

// A lumen from a file that cannot be used: exit 2 and one message, before anything is written.
#include <fmt/format.h>

#include <limits>

#include "bridge/surface/StlFile.h"
#include "tests/support/FlowSupport.h"
#include "tests/support/HookTube.h"
#include "tests/support/SweptTube.h"
#include "tests/support/TubeSurface.h"
#include "tests/support/WholeProgram.h"

namespace restenosis {
namespace {

using namespace support;

constexpr std::string_view loadedScene = R"([scene]
duration = "1 h"
step = "1 h"

[vessel]
lumenSurface = "lumen.stl"
lumenSurfaceUnit = "mm"

[flow]
backend = "foam"
)";

class WrongLumen : public WholeProgram {
 protected:
  void write(const TriSurface& surface) const { writeStl(folder / "lumen.stl", surface, 1e-3); }
  void expectRefused(std::string_view text, const std::vector<std::string>& says,
                     std::vector<std::string> more = {}) {
    std::vector<std::string> arguments = {"run", scene("loaded", text), "-o", "out"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const ProcessEnd end = run(arguments);
    EXPECT_EXIT_STATUS(end, 2);
    EXPECT_EQ(std::ranges::count(end.err, '\n'), 1) << end.err;
    for (const auto& part : says) EXPECT_NE(end.err.find(part), std::string::npos) << part << '\n' << end.err;
    EXPECT_FALSE(exists("out"));
  }
  const TriSurface good = tube(vesselRadius, vesselLength);
};

TEST_F(WrongLumen, MissingFile) {
  expectRefused(loadedScene, {"loaded.toml:6: ", "lumen.stl does not exist"});
}

TEST_F(WrongLumen, AmongTheResultsThatANewRunWouldMoveAside) {
  for (const char* file : {"old/flow/0/lumen.stl", "old/previous/flow/0/lumen.stl"}) {
    std::filesystem::create_directories((folder / file).parent_path());
    writeText(folder / "old/.restenosisFoam", "");
    writeStl(folder / file, good, 1e-3);
    const std::string loaded = scene("loaded", with(std::string(loadedScene), "lumen.stl", file));
    const ProcessEnd end = run({"run", loaded, "-o", "old", "--flow", "none"});
    EXPECT_EXIT_STATUS(end, 2);
    EXPECT_NE(end.err.find("lies among the results in old"), std::string::npos) << end.err;
    EXPECT_TRUE(exists(file));
  }
}

TEST_F(WrongLumen, Hole) {
  TriSurface hole = good;
  hole.triangles.erase(hole.triangles.begin() + 600), hole.region.pop_back();
  write(hole);
  expectRefused(loadedScene, {"loaded.toml:6: ", "it has a hole of 3 edges"});
}

TEST_F(WrongLumen, HoleInACap) {
  TriSurface hole = good;
  hole.triangles.pop_back(), hole.region.pop_back();
  write(hole);
  expectRefused(loadedScene, {"loaded.toml:6: ", "it has a hole of 3 edges", "in an end cap of 1.8 mm"});
}

TEST_F(WrongLumen, PassesThroughItself) {
  TriSurface crossed = tube(vesselRadius, vesselLength, 3);
  for (Vec3& v : crossed.vertices)  // one of its rings, turned over the axis
    if (v.z() > 0.4 * vesselLength && v.z() < 0.9 * vesselLength) v.head<2>() *= -0.5;
  write(crossed);
  expectRefused(loadedScene, {"loaded.toml:6: ", "it passes through itself: ", " mm"});
  EXPECT_EXIT_STATUS(run({"check", scene("loaded", loadedScene)}), 2);
}

TEST_F(WrongLumen, CutOff) {
  write(good);
  const std::string whole = readText(folder / "lumen.stl");
  writeText(folder / "lumen.stl", whole.substr(0, whole.size() - 30));
  expectRefused(loadedScene, {"loaded.toml:6: ", "lumen.stl is cut off"});
  writeNamedStl(folder / "lumen.stl", good, 1e-3);
  const std::string text = readText(folder / "lumen.stl");
  writeText(folder / "lumen.stl", text.substr(0, text.rfind("vertex")));
  expectRefused(loadedScene, {"loaded.toml:6: ", "lumen.stl:", "the file is cut off"});
}

TEST_F(WrongLumen, FilesThatWereJoinedAreOneLumen) {
  TriSurface half[2];
  for (std::size_t t = 0; t < good.triangles.size(); ++t) {
    TriSurface& part = half[good.centre(t).z() > vesselLength / 2];
    part.triangles.push_back(good.triangles[t]), part.region.push_back(good.region[t]);
  }
  std::string joined;
  for (TriSurface& part : half) {
    part.vertices = good.vertices;
    write(part);
    joined += readText(folder / "lumen.stl");
  }
  writeText(folder / "lumen.stl", joined);
  const ProcessEnd end = run({"run", scene("loaded", loadedScene), "-o", "out", "--flow", "analytic"});
  ASSERT_EXIT_STATUS(end, 0);
  EXPECT_NEAR(summary("out")["final"]["wssMean_Pa"], vesselStress(), 0.01 * vesselStress());
  std::filesystem::remove_all(folder / "out");

  writeText(folder / "lumen.stl", joined + std::string(50, 'x'));
  expectRefused(loadedScene,
                {"loaded.toml:6: ", "lumen.stl holds more than it announces: its header announces ",
                 " triangles, it has room for "});
}

TEST_F(WrongLumen, ASolidsNameThatDoesNotFitIt) {
  writeNamedStl(folder / "lumen.stl", good, 1e-3);
  const std::string text = readText(folder / "lumen.stl");
  const auto rename = [&](std::string_view name) {
    const auto from = std::string("solid wall"), to = "solid " + std::string(name);
    writeText(folder / "lumen.stl", with(with(text, from, to), "endsolid wall", "end" + to));
  };
  rename("STL of lumen with inlet and outlet");
  expectRefused(loadedScene,
                {"loaded.toml:6: ", "the name of the solid 'STL of lumen with inlet and outlet' says"});
  rename("inlet part");
  expectRefused(loadedScene, {"loaded.toml:6: ", "'inlet part'", "named as the inlet, which must be planar",
                              " mm2 from "});
}

TEST_F(WrongLumen, WhatIsTakenForWhatIsListed) {
  TriSurface turned = good;
  for (auto& region : turned.region)
    if (region != SurfaceRegion::wall)
      region = region == SurfaceRegion::inlet ? SurfaceRegion::outlet : SurfaceRegion::inlet;
  writeNamedStl(folder / "lumen.stl", turned, 1e-3);
  const std::string inlet =
      fmt::format("  inlet   2.545 mm2, 1.8 mm wide around (0, 0, {:g}) mm: the solid 'inlet', by its name\n",
                  1e3 * vesselLength);
  EXPECT_NE(run({"check", scene("loaded", loadedScene)}).out.find(inlet), std::string::npos);
  const ProcessEnd end = run({"run", scene("loaded", loadedScene), "-o", "out", "--flow", "analytic"});
  ASSERT_EXIT_STATUS(end, 0);
  EXPECT_NE(end.err.find(inlet), std::string::npos) << end.err;
}

TEST_F(WrongLumen, AWidthOfAnotherUnit) {
  writeStl(folder / "lumen.stl", good, 1e-2);
  const std::string centimetres = with(loadedScene, "\"mm\"", "\"cm\"");
  const ProcessEnd right = run({"check", scene("loaded", centimetres)});
  EXPECT_EXIT_STATUS(right, 0);
  EXPECT_NE(right.out.find("lumen 1.8 mm"), std::string::npos) << right.out;
  EXPECT_EQ(right.out.find("coronary"), std::string::npos) << right.out;

  const ProcessEnd wrong = run({"run", scene("loaded", loadedScene), "-o", "out", "--flow", "analytic"});
  ASSERT_EXIT_STATUS(wrong, 0);
  EXPECT_NE(wrong.err.find("is 0.18 mm wide; coronary arteries are 0.8 to 8 mm wide"), std::string::npos)
      << wrong.err;
  const std::string recorded = summary("out")["remarks"][0];
  EXPECT_TRUE(recorded.ends_with("lumenSurfaceUnit, mm, right? In cm it would be 1.8 mm.")) << recorded;
}

TEST_F(WrongLumen, OneEndOnly) {
  TriSurface blind = good;
  for (Vec3& v : blind.vertices)
    if (v.head<2>().norm() < 1e-9 && v.z() > 0) v.z() += 2e-3;
  write(blind);
  expectRefused(loadedScene, {"loaded.toml:6: ", "two planar ends", "1 was found"});
}

TEST_F(WrongLumen, WrongUnit) {
  write(good);
  expectRefused(with(loadedScene, "\"mm\"", "\"m\""), {"loaded.toml:6: ", "1800 mm wide", "length unit"});
  expectRefused(with(loadedScene, "\"mm\"", "\"um\"\nlumenDiameter = \"1.8 mm\""), {"length unit"});
  const std::string tenfold = with(loadedScene, "\"mm\"", "\"mm\"\nlumenDiameter = \"18 mm\"");
  expectRefused(tenfold, {"loaded.toml:7: 'lumenSurfaceUnit' in [vessel]", "1.8 mm wide"});
}

TEST_F(WrongLumen, ALengthThatIsNotTheSurfaces) {
  write(tube(vesselRadius, 2e-3));
  for (const char* length : {"8 mm", "0.5 mm"})
    expectRefused(with(loadedScene, "\"mm\"", fmt::format("\"mm\"\nlength = \"{}\"", length)),
                  {"loaded.toml:8: 'length' in [vessel]", "are 2 mm apart", length});
  const auto roughly = with(loadedScene, "\"mm\"", "\"mm\"\nlength = \"3 mm\"");
  const ProcessEnd rough = run({"check", scene("loaded", roughly)});
  EXPECT_EXIT_STATUS(rough, 0);
  EXPECT_NE(rough.out.find("vessel 2 mm long"), std::string::npos) << rough.out;
  write(bentTube(0.5e-3, 0.6e-3, 1e-3, 0.4e-3));
  const auto bent = with(loadedScene, "\"mm\"", "\"mm\"\nlength = \"8 mm\"");
  EXPECT_EXIT_STATUS(run({"check", scene("loaded", bent)}), 0);
}

TEST_F(WrongLumen, LongerThanAnyVessel) {
  write(tube(vesselRadius, 1.2));
  expectRefused(loadedScene,
                {"loaded.toml:6: 'lumenSurface' in [vessel]", "1200 mm apart", "at most 1000 mm"});
}

TEST_F(WrongLumen, TooNarrowForItsCells) {
  write(tube(0.1e-3, 1e-3));
  const std::string said = "a lumen of 0.2 mm has 3.3 cells across, at least 8 are needed";
  expectRefused(loadedScene, {"'cellSize' in [foam] is 60 um", said,
                              "lumenSurfaceUnit, mm, right? In cm it would be 2 mm."});
  const ProcessEnd checked = run({"check", scene("loaded", loadedScene)});
  EXPECT_EXIT_STATUS(checked, 2);
  EXPECT_NE(checked.err.find(said), std::string::npos) << checked.err;
}

TEST_F(WrongLumen, NotANumber) {
  TriSurface broken = good;
  broken.vertices[7].x() = std::numeric_limits<double>::quiet_NaN();
  write(broken);
  expectRefused(loadedScene, {"loaded.toml:6: ", "not a finite number"});
}

TEST_F(WrongLumen, BentForABackendThatNeedsStraight) {
  write(bentTube(vesselRadius, 1e-3, 2e-3, 1e-3));
  expectRefused(loadedScene, {"'backend' in [flow]", "90 degrees from parallel", "choose foam or lbm"},
                {"--flow", "analytic"});
}

TEST_F(WrongLumen, StraightEndsThatRunIntoTheVessel) {
  write(openRing());
  const auto withEnds = [](const char* length) {
    return std::string(loadedScene) + "straightEnds = \"" + length + "\"\n[foam]\ncellSize = \"0.09 mm\"\n";
  };
  const std::vector<std::string> says = {"loaded.toml:11: 'straightEnds' in [flow]",
                                         "run into the lumen or each other, at (", "there is room for "};
  expectRefused(withEnds("3 mm"), says);
  const ProcessEnd checked = run({"check", scene("loaded", withEnds("3 mm"))});
  EXPECT_EXIT_STATUS(checked, 2);
  EXPECT_NE(checked.err.find(says.front()), std::string::npos) << checked.err;
  EXPECT_EXIT_STATUS(run({"check", scene("loaded", withEnds("0.4 mm"))}), 0);
}

TEST_F(WrongLumen, NotWithStenosis) {
  write(good);
  expectRefused(with(loadedScene, "\"mm\"", "\"mm\"\nstenosis = 0.5"), {"'stenosis' shapes a cylinder"});
}

TEST_F(WrongLumen, NarrowerThanTheSpacingOfOtherLumensIsNone) {
  write(tube(0.06e-3, 0.5e-3));
  const ProcessEnd end = run({"check", scene("loaded", loadedScene), "--flow", "analytic"});
  EXPECT_EXIT_STATUS(end, 0);
}

TEST_F(WrongLumen, AGoodOneRuns) {
  write(moved(good, motionTo(Vec3(1, 2, 3), Vec3(5e-3, 0, 0))));
  const ProcessEnd end = run({"run", scene("loaded", loadedScene), "-o", "out", "--flow", "analytic"});
  ASSERT_EXIT_STATUS(end, 0);
  EXPECT_NEAR(summary("out")["final"]["wssMean_Pa"], vesselStress(), 0.01 * vesselStress());
  EXPECT_TRUE(exists("out/lumen.pvd"));
}

}  // namespace
}  // namespace restenosis

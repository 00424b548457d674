// A stent from an STL is pressed in as a design of the same shape is.
#include "bridge/surface/StlFile.h"
#include "tests/support/StrutSolids.h"
#include "tests/support/WholeProgram.h"

namespace restenosis {
namespace {

class StentFromStl : public WholeProgram {
 protected:
  nlohmann::json deployed(const std::string& name, const std::string& text) const {
    const ProcessEnd end =
        run({"run", scene(name, text), "-o", name, "--flow", "none", "--threads", "1", "--set",
             "cellCycle=absent", "--set", "contactInhibition=absent", "--set", "endothelium=absent", "--set",
             "injury=absent", "--set", "scene.duration=2 h"});
    EXPECT_EXIT_STATUS(end, 0);
    return summary(name)["deployment"];
  }
  void write(const TriSurface& surface) const { writeStl(folder / "ring.stl", surface, 1e-3); }
  void expectRefused(const std::string& text, const std::vector<std::string>& says) const {
    const ProcessEnd end = run({"run", scene("wrong", text), "-o", "wrong"});
    EXPECT_EXIT_STATUS(end, 2);
    for (const auto& part : says) EXPECT_NE(end.err.find(part), std::string::npos) << part << '\n' << end.err;
    EXPECT_FALSE(exists("wrong"));
  }

  const std::string loadedScene = with(tinyScene, "design = \"ring\"", "file = \"ring.stl\"");
  const TriSurface good = support::squareRing(0.2e-3, 60e-6, 0.24e-3);
};

TEST_F(StentFromStl, DeploysAsTheDesignDoes) {
  write(good);
  const auto design = deployed("design", std::string(tinyScene)), stl = deployed("stl", loadedScene);
  EXPECT_EQ(stl["agentsLumenwardOfStruts"], 0);
  EXPECT_EQ(stl["cellsOutsideEel"], 0);
  // Spheres of 18 um stand elsewhere on the same faces, and agents near one of them count as beneath the
  // strut, in the middle of the strut or not: a sixth of a radius
  EXPECT_NEAR(stl["ielRadiusUnderStruts_um"], double(design["ielRadiusUnderStruts_um"]), 3.0);
  EXPECT_NEAR(stl["ielToEelUnderStruts_um"], double(design["ielToEelUnderStruts_um"]), 3.0);
}

TEST_F(StentFromStl, FilesThatCannotBeUsedAreRefusedBeforeAnythingIsWritten) {
  expectRefused(loadedScene, {"wrong.toml:15: 'file' in [stent]", "ring.stl does not exist"});
  writeText(folder / "ring.stl", "x,y,z,radius\n");
  expectRefused(loadedScene, {"wrong.toml:15: 'file' in [stent]: ", "ring.stl:1: "});
  TriSurface hole = good;
  hole.triangles.pop_back(), hole.region.pop_back();
  write(hole);
  expectRefused(loadedScene, {"wrong.toml:15: 'file' in [stent]: ", "is not closed: 3 edges"});
  write(good);
  expectRefused(
      with(loadedScene, "ring.stl\"", "ring.stl\"\nfileUnit = \"m\""),
      {"wrong.toml:15: 'file' in [stent]: ", "allowed are 0 to 240 um", "taken to be m (fileUnit)"});
  expectRefused(with(loadedScene, "ring.stl\"", "ring.stl\"\nfileUnit = \"um\""),
                {"wrong.toml:15: 'file' in [stent]: ", "thinner than 2 um"});
}

}  // namespace
}  // namespace restenosis

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>

#include "tests/support/LoadedLumenFixture.h"
#include "tests/support/SweptTube.h"
#include "tests/support/TubeSurface.h"

namespace restenosis {
namespace {

using namespace support;

/// The text with all of its `from` replaced.
std::string replacedAll(std::string text, std::string_view from, std::string_view to) {
  for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

class NamedLumen : public LoadedLumenFixture {
 protected:
  /// Writes a tube with the ends and the wall under these names.
  void writeNames(std::string_view inlet, std::string_view outlet, std::string_view wall) const {
    writeNamedStl(file, stentedTube(vesselRadius, 2e-3, 0.1e-3), 1e-3);
    std::string text = replacedAll(readText(file), "solid inlet", "solid I#");
    text = replacedAll(replacedAll(text, "solid outlet", "solid O#"), "solid wall", "solid W#");
    for (const auto& [mark, name] : {std::pair{"I#", inlet}, {"O#", outlet}, {"W#", wall}})
      text = replacedAll(text, mark, name);
    writeText(file, text);
  }
  /// Writes a tube in halves, the one with the inlet at z = 0 first.
  void writeHalves(std::string_view low, std::string_view high) const {
    TriSurface halves = tube(vesselRadius, 2e-3);
    for (std::size_t t = 0; t < halves.triangles.size(); ++t)
      halves.region[t] = halves.centre(t).z() < 1e-3 ? SurfaceRegion::wall : SurfaceRegion::strut;
    writeNamedStl(file, halves, 1e-3);
    std::string text = replacedAll(readText(file), "solid wall", fmt::format("solid {}", low));
    writeText(file, replacedAll(text, "solid strut", fmt::format("solid {}", high)));
  }
  void expectBackwards(bool backwards) const {
    const Vec3 low(0, 0, 0), high(0, 0, 2e-3);
    const TriSurface lumen = loadLumen(file, 1e-3);
    expectEnds(lumen, backwards ? high : low, backwards ? low : high);
  }
};

TEST_F(NamedLumen, NamesOfSolidsDecide) {
  TriSurface named = stentedTube(vesselRadius, 2e-3, 0.1e-3);
  for (auto& r : named.region) {  // against the rule for files without names
    if (r == SurfaceRegion::inlet) {
      r = SurfaceRegion::outlet;
    } else if (r == SurfaceRegion::outlet) {
      r = SurfaceRegion::inlet;
    }
  }
  writeNamedStl(file, named, 1e-3);
  const TriSurface lumen = loadLumen(file, 1e-3);
  expectEnds(lumen, Vec3(0, 0, 2e-3), Vec3(0, 0, 0));
  EXPECT_EQ(std::ranges::count(lumen.region, SurfaceRegion::strut),
            std::ranges::count(named.region, SurfaceRegion::strut));
}

TEST_F(NamedLumen, NamesInCapitalsDecideToo) {
  TriSurface named = tube(vesselRadius, 2e-3);
  for (auto& r : named.region)
    if (r != SurfaceRegion::wall)
      r = r == SurfaceRegion::inlet ? SurfaceRegion::outlet : SurfaceRegion::inlet;
  writeNamedStl(file, named, 1e-3);
  std::string text = readText(file);
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  writeText(file, text);
  expectEnds(loadLumen(file, 1e-3), Vec3(0, 0, 2e-3), Vec3(0, 0, 0));
}

TEST_F(NamedLumen, OtherNamesOfEndsAreKnown) {
  for (const auto& [in, out] : {std::pair{"inlet", "outlet"},
                                {"inflow", "outflow"},
                                {"Inflow", "OUTFLOW_1"},
                                {"in", "out"},
                                {"vesselInlet", "vesselOutlet"},
                                {"Inlet-Cap", "cap_out"}}) {
    writeNames(out, in, "lumen");
    expectBackwards(true);
    writeNames(in, out, "lumen");
    expectBackwards(false);
    writeNames("first", in, "artery");  // one is enough
    expectBackwards(true);
  }
}

TEST_F(NamedLumen, PartsOfWordsAreNoNames) {
  writeHalves("proximal", "stented segment");
  const TriSurface lumen = loadLumen(file, 1e-3);
  EXPECT_EQ(std::ranges::count(lumen.region, SurfaceRegion::strut), 0);
  expectBackwards(false);
  writeHalves("outletted", "inletted");
  expectBackwards(false);
}

TEST_F(NamedLumen, TheNameOfAllThereIsIsATitle) {
  TriSurface whole = tube(vesselRadius, 2e-3);
  whole.region.assign(whole.region.size(), SurfaceRegion::wall);
  writeNamedStl(file, whole, 1e-3);
  const std::string text = readText(file);
  for (const char* title : {"STL of lumen with inlet and outlet caps, units mm", "outlet", "stented lumen"}) {
    writeText(file, replacedAll(text, "solid wall", fmt::format("solid {}", title)));
    expectBackwards(false);
  }
}

TEST_F(NamedLumen, ANameOfTwoThingsIsRefused) {
  writeHalves("proximal", "in-stent segment");
  EXPECT_SAYS(refusalOfFile(),
              "the name of the solid 'in-stent segment' says that it is strut and wall at once; "
              "it has 1664 triangles of ");
  EXPECT_SAYS(refusalOfFile(), " mm2 from (-0.9, -0.9, 1) to (0.9, 0.9, 2) mm");
  writeNames("inlet", "outlet", "STL of lumen with inlet and outlet caps, units mm");
  EXPECT_SAYS(refusalOfFile(),
              "the name of the solid 'STL of lumen with inlet and outlet caps,...' says that it "
              "is inlet and outlet at once");
}

TEST_F(NamedLumen, AnEndThatIsNotPlanarIsRefusedByName) {
  writeHalves("the inlet side", "distal inlet");
  EXPECT_SAYS(refusalOfFile(), "the solids 'the inlet side' and 'distal inlet', named as the inlet");
  writeHalves("vessel", "distal inlet");
  EXPECT_SAYS(refusalOfFile(),
              "the solid 'distal inlet', named as the inlet, which must be planar, has 1664 "
              "triangles of ");
  EXPECT_SAYS(refusalOfFile(), "up to 0.");
  EXPECT_SAYS(refusalOfFile(), "Rename it, or give the end a solid of its own");
}

TEST_F(NamedLumen, AnEndInAStrutIsRefusedByName) {
  writeHalves("vessel", "stent");
  EXPECT_SAYS(refusalOfFile(),
              "in the solid 'stent', named as struts, there is the end of the lumen 1.8 mm wide around "
              "(0, 0, 2) mm");
}

TEST_F(NamedLumen, AWallOfStrutsOnlyIsRefused) {
  writeNames("inlet", "outlet", "stents");
  EXPECT_SAYS(refusalOfFile(),
              "there is no wall in it: beside the ends there is only the solids 'stents' and 'strut', named "
              "as struts");
}

TEST_F(NamedLumen, OneNameForBothEndsIsRefused) {
  writeNames("outlet1", "outlet2", "wall");
  EXPECT_SAYS(refusalOfFile(),
              "what is named outlet is 2 separate pieces: the solid 'outlet1', 1.8 mm wide around "
              "(0, 0, 0) mm, and the solid 'outlet2', 1.8 mm wide around (0, 0, 2) mm; it must be "
              "one end. Of a bifurcation take one branch, and close the others");
}

TEST_F(NamedLumen, PartsAreListedWithWhatTheyCameFrom) {
  writeNames("outflow", "INFLOW", "artery");
  DescribedLumen lumen = loadDescribedLumen(file, 1e-3);
  ASSERT_EQ(lumen.parts.size(), 4u);
  EXPECT_EQ(lumen.parts[0],
            "inlet   2.545 mm2, 1.8 mm wide around (0, 0, 2) mm: the solid 'INFLOW', by its name");
  EXPECT_EQ(lumen.parts[1],
            "outlet  2.545 mm2, 1.8 mm wide around (0, 0, 0) mm: the solid 'outflow', by its name");
  EXPECT_SAYS(lumen.parts[2],
              "wall    3072 triangles of 10.75 mm2 from (-0.9, -0.9, 0) to (0.9, 0.9, 2) mm: ");
  EXPECT_SAYS(lumen.parts[2], "the solid 'artery'");
  EXPECT_SAYS(lumen.parts[3], "strut   768 triangles of ");
  EXPECT_SAYS(lumen.parts[3], "(0.9, 0.9, 1.05) mm: the solid 'strut'");
  EXPECT_TRUE(lumen.remarks.empty());

  lumen = (load(moved(tube(vesselRadius, 2e-3), motionTo(Vec3(-1, 0, 0), Vec3(0, 0, 0)))),
           loadDescribedLumen(file, 1e-3));
  ASSERT_EQ(lumen.parts.size(), 5u);
  EXPECT_EQ(lumen.parts[0], "inlet   2.545 mm2, 1.8 mm wide around (-2, 0, 0) mm: a flat cap");
  EXPECT_SAYS(lumen.parts[2], "mm: what is no end");
  EXPECT_EQ(lumen.parts[3], "strut   none: no solid is named so");
  EXPECT_EQ(lumen.parts[4], "no solid is named inlet or outlet: the inlet is the end with the lower x");

  const SurfaceRegion wall[] = {SurfaceRegion::wall};
  load(tube(vesselRadius, 2e-3), wall);
  EXPECT_SAYS(loadDescribedLumen(file, 1e-3).parts[1], "around (0, 0, 2) mm: an open rim, closed");
  writeHalves("a", "b");
  EXPECT_SAYS(loadDescribedLumen(file, 1e-3).parts[0], "around (0, 0, 0) mm: a flat cap in the solid 'a'");
}

TEST_F(NamedLumen, StrutsWithoutAnEdgeAreRemarkedOn) {
  TriSurface smooth = tube(vesselRadius, 2e-3);
  for (std::size_t t = 0; t < smooth.triangles.size(); ++t)
    if (std::abs(smooth.centre(t).z() - 1e-3) < 0.3e-3) smooth.region[t] = SurfaceRegion::strut;
  writeNamedStl(file, smooth, 1e-3);
  ASSERT_EQ(loadDescribedLumen(file, 1e-3).remarks.size(), 1u);
  EXPECT_SAYS(loadDescribedLumen(file, 1e-3).remarks[0],
              "the solid 'strut', named as struts, lies in the wall without an edge, ");
  for (std::size_t t = 0; t < smooth.triangles.size(); ++t)
    if (std::abs(smooth.centre(t).z() - 1e-3) < 0.6e-3) smooth.region[t] = SurfaceRegion::strut;
  writeNamedStl(file, smooth, 1e-3);
  EXPECT_SAYS(loadDescribedLumen(file, 1e-3).remarks.at(0), "makes 58.3 % of the lumen's side struts");
}

}  // namespace
}  // namespace restenosis

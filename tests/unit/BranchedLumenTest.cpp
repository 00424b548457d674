#include <gtest/gtest.h>

#include "bridge/flow/LumenShape.h"
#include "bridge/flow/StraightEnds.h"
#include "bridge/surface/LoadedLumen.h"
#include "bridge/surface/StlFile.h"
#include "bridge/surface/SurfaceEnds.h"
#include "tests/support/ExpectSays.h"
#include "tests/support/TemporaryFolder.h"

namespace restenosis {
namespace {

/// The coronary artery of the scene `patient`.
class BranchedLumen : public ::testing::Test {
 protected:
  DescribedLumen load(Outlets outlets) const {
    return loadDescribedLumen(folder_ / "tree.stl", 1e-3, outlets);
  }
  std::string refused(Outlets outlets) const {
    try {
      load(outlets);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "accepted";
  }
  void write(std::string_view from = "", std::string_view to = "") const {
    std::string text = readText(RESTENOSIS_SOURCE_DIR "/scenes/patient.stl");
    for (auto at = text.find(from); !from.empty() && at != std::string::npos;
         at = text.find(from, at + to.size()))
      text.replace(at, from.size(), to);
    writeText(folder_ / "tree.stl", text);
  }
  void leaveOut(const std::string& solid) const {
    std::string text = readText(RESTENOSIS_SOURCE_DIR "/scenes/patient.stl");
    const auto from = text.find("solid " + solid), to = text.find("endsolid " + solid);
    text.erase(from, text.find('\n', to) + 1 - from);
    writeText(folder_ / "tree.stl", text);
  }

 private:
  TemporaryFolder folder_;
};

TEST_F(BranchedLumen, HasItsOutletsInTheOrderOfTheirNames) {
  write();
  const DescribedLumen lumen = load(Outlets::several);
  EXPECT_EQ(lumen.outlets,
            (std::vector<std::string>{"outlet_anterior_descending", "outlet_circumflex", "outlet_diagonal"}));
  EXPECT_EQ(lumen.surface.outletCount(), 3U);
  EXPECT_NO_THROW(requireLumenWithPlanarEnds(lumen.surface));
  EXPECT_NEAR(endDiameter(lumen.surface, outletRegion(2)), 2e-3, 0.05e-3);
  EXPECT_SAYS(lumen.parts[3], "outlet3 3.116 mm2, 1.992 mm wide");
  EXPECT_FALSE(liesAlongZ(lumen.surface));
}

TEST_F(BranchedLumen, GoesOnAtEachEnd) {
  write();
  const TriSurface lumen = load(Outlets::several).surface, longer = withStraightEnds(lumen, 1e-3);
  EXPECT_TRUE(surfaceEdges(longer).open.empty());
  double ends = 0;
  for (const SurfaceRegion region : allRegions(lumen))
    if (isEnd(region)) ends += endPlane(lumen, region).area;
  EXPECT_NEAR(enclosedVolume(longer) - enclosedVolume(lumen), 1e-3 * ends, 1e-6 * enclosedVolume(lumen));
}

TEST_F(BranchedLumen, IsRefusedWhereOneOutletIsWanted) {
  write();
  EXPECT_SAYS(refused(Outlets::one), "what is named outlet is 3 separate pieces");
}

TEST_F(BranchedLumen, ThatCannotBeToldIsRefused) {
  write("solid inlet", "solid beginning");
  EXPECT_SAYS(refused(Outlets::several), "3 solids are named as outlets, but none as the inlet");
  write("outlet_diagonal", "outlet_circumflex");
  EXPECT_SAYS(refused(Outlets::several), "two outlets are named 'outlet_circumflex'");
  leaveOut("outlet_diagonal");
  EXPECT_SAYS(refused(Outlets::several), "it has 2 outlets that are named, and one end that is open");
}

}  // namespace
}  // namespace restenosis

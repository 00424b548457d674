#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "bridge/flow/foam/FoamBackend.h"
#include "bridge/flow/foam/FoamLog.h"
#include "tests/support/FlowSupport.h"
#include "tests/support/OpenFoamPresent.h"
#include "tests/support/TemporaryFolder.h"
#include "tests/support/TubeSurface.h"

namespace restenosis {
namespace {

using namespace support;

/// Area-weighted L2 difference of `a` from the nearest face of `b`, against the mean stress.
double l2Difference(const FlowSolution& a, const FlowSolution& b) {
  double sum = 0.0, area = 0.0;
  for (const WallFace& f : a.wall) {
    const WallFace* nearest = nullptr;
    double least = std::numeric_limits<double>::infinity();
    for (const WallFace& g : b.wall)
      if (const double d = (f.centre - g.centre).squaredNorm(); g.region == f.region && d < least)
        least = d, nearest = &g;
    sum += f.area * (f.traction - nearest->traction).squaredNorm();
    area += f.area;
  }
  return std::sqrt(sum / area) / meanStress(b);
}

/// Measured: the mean differs by 1e-6 to 2e-6, L2 by 1e-4 to 2e-4.
TEST(FoamExecution, ranksGiveTheStressOfOneProcessAndACaseLikeIts) {
  RESTENOSIS_NEEDS_OPENFOAM();
  const TemporaryFolder scratch;
  const auto settings = FoamSettings::forFidelity("draft");
  const auto lumen = stentedTube(vesselRadius, 0.7 * vesselLength, 90e-6);
  const auto folder = scratch / "ranked";
  const auto serial = FoamBackend(settings).solve(lumen, vesselConditions(), scratch / "serial");
  const auto ranked = FoamBackend(settings, {.ranks = 2}).solve(lumen, vesselConditions(), folder);

  const double mean = meanStress(ranked) / meanStress(serial) - 1.0, l2 = l2Difference(ranked, serial);
  RecordProperty("meanDifference", std::to_string(mean));
  RecordProperty("l2Difference", std::to_string(l2));
  EXPECT_LT(std::abs(mean), 0.005);
  EXPECT_LT(l2, 0.005);
  EXPECT_NEAR(ranked.pressureDrop / serial.pressureDrop, 1.0, 0.005);
  EXPECT_LT(ranked.massImbalance, 1e-4);
  EXPECT_TRUE(ranked.remarks.empty());

  // One mesh, one folder of fields, nothing left of the ranks: what a reader finds in a serial case
  const auto faces = foamLog::patchFaces(foamLog::read(folder / "constant/polyMesh/boundary"));
  std::set<std::string> patches;
  for (const auto& [patch, count] : faces)
    if (count > 0) patches.insert(patch);
  EXPECT_EQ(patches, (std::set<std::string>{"inlet", "outlet", "wall", "strut"}));
  EXPECT_EQ(faces.at("wall") + faces.at("strut"), ranked.wall.size());
  const auto last = folder / std::to_string(ranked.iterations);
  for (const char* field : {"U", "p", "wallShearStress"}) EXPECT_TRUE(std::filesystem::exists(last / field));
  EXPECT_TRUE(std::filesystem::exists(folder / "case.foam"));
  EXPECT_FALSE(std::filesystem::exists(folder / "processor0"));
}

}  // namespace
}  // namespace restenosis

#include <gtest/gtest.h>

#include "bridge/coupling/CrossCheck.h"
#include "bridge/scene/SceneBiology.h"
#include "tests/support/Constants.h"
#include "tests/support/FlowSupport.h"
#include "tests/support/TubeSurface.h"

namespace restenosis {
namespace {

using namespace support;

/// Faces of a flow on the lumen's own triangles; `stress` [Pa] by region.
template <class Stress>
FlowSolution flowWith(const TriSurface& lumen, const Stress& stress) {
  FlowSolution flow;
  for (std::size_t t = 0; t < lumen.triangles.size(); ++t) {
    const SurfaceRegion region = lumen.region[t];
    if (region != SurfaceRegion::wall && region != SurfaceRegion::strut) continue;
    flow.wall.push_back(
        {lumen.centre(t), lumen.areaVector(t).norm(), stress(region) * Vec3::UnitZ(), region});
  }
  return flow;
}

TEST(CrossCheck, tellsTheDifferenceOnWallAndStruts) {
  const TriSurface lumen = stentedTube(vesselRadius, 2.0 * vesselLength, 90e-6);
  const auto own = flowWith(lumen, [](SurfaceRegion) { return 2.0; });
  const auto other =
      flowWith(lumen, [](SurfaceRegion region) { return region == SurfaceRegion::strut ? 3.0 : 1.8; });
  const CrossCheckRecord found = stressDifferences(lumen, {}, own, other);
  ASSERT_TRUE(found.smoothWall && found.nearStruts && found.struts);
  for (const StressDifference& wall : {*found.smoothWall, *found.nearStruts}) {
    EXPECT_NEAR(wall.mean, -0.1, 1e-12);
    EXPECT_NEAR(wall.l2, 0.1, 1e-12);
  }
  EXPECT_NEAR(found.struts->mean, 0.5, 1e-12);
  EXPECT_NEAR(found.struts->l2, 0.5, 1e-12);
}

TEST(CrossCheck, saysNothingOfStrutsWhereThereAreNone) {
  const TriSurface lumen = tube(vesselRadius, vesselLength);
  const auto flow = flowWith(lumen, [](SurfaceRegion) { return 1.0; });
  const CrossCheckRecord found = stressDifferences(lumen, {}, flow, flow);
  ASSERT_TRUE(found.smoothWall);
  EXPECT_EQ(found.smoothWall->mean, 0.0);
  EXPECT_EQ(found.smoothWall->l2, 0.0);
  EXPECT_FALSE(found.struts);
}

/// Four covered cells and a bare one along the vessel.
AgentStore cellsUnderFlow() {
  AgentStore agents;
  for (int n = 0; n < 5; ++n) {
    agents.append(AgentKind::smc, Vec3(vesselRadius, 0, n * 1e-4), r);
    const Index i = agents.size() - 1;
    agents.set(i, synthetic, true);
    agents.set(i, exposed, true);
    agents.set(i, covered, n < 4);
  }
  return agents;
}

/// A face in front of each of these cells, with its stress [Pa].
FlowSolution inFrontOf(const AgentStore& agents, std::initializer_list<double> stresses) {
  FlowSolution flow;
  Index i = 0;
  for (const double stress : stresses)
    flow.wall.push_back(
        {agents.position(i++) - Vec3(r, 0, 0), 1e-10, stress * Vec3::UnitZ(), SurfaceRegion::wall});
  return flow;
}

TEST(CrossCheck, countsTheCoveredCellsThatWouldRestByOneFlowAlone) {
  BiologySettings settings;
  settings.cellCycle.emplace();
  settings.endothelium.emplace();
  const Biology biology(settings);
  const double enough = 2 * biology.arrestingWss(), little = 0.5 * biology.arrestingWss();
  const AgentStore agents = cellsUnderFlow();
  const auto share = [&](std::initializer_list<double> own, std::initializer_list<double> other) {
    return decidedOtherwise(agents, biology, inFrontOf(agents, own), inFrontOf(agents, other));
  };
  EXPECT_EQ(share({enough, enough, little, little, little}, {enough, little, enough, little, enough}), 0.5);
  EXPECT_EQ(share({enough, enough, little, little, little}, {3 * enough, enough, 0, 0, 0}), 0.0);
  EXPECT_EQ(share({little, little, little, little, little}, {enough, enough, enough, enough, enough}), 1.0);
}

TEST(CrossCheck, hasNothingToDecideWhereNoCellIsCovered) {
  BiologySettings settings;
  settings.endothelium.emplace();
  const Biology biology(settings);
  AgentStore bare = cellsUnderFlow();
  for (Index i = 0; i < bare.size(); ++i) bare.set(i, covered, false);
  const auto flow = inFrontOf(bare, {1, 1, 1, 1, 1});
  EXPECT_FALSE(decidedOtherwise(bare, biology, flow, flow));
}

}  // namespace
}  // namespace restenosis

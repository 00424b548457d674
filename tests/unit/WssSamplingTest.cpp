#include <gtest/gtest.h>

#include <limits>

#include "bridge/sampling/WssSampling.h"
#include "tissue/agents/RandomStream.h"

namespace restenosis {
namespace {

struct WssSampling : testing::Test {
  AgentStore agents;
  std::vector<WallFace> faces;

  Index addCell(const Vec3& p, double radius, bool exposed = true, AgentKind kind = AgentKind::smc) {
    const Index i = agents.append(kind, p, radius);
    agents.set(i, AgentFlag::exposed, exposed);
    return i;
  }
  void addFace(const Vec3& p, double area, double stress, SurfaceRegion region = SurfaceRegion::wall) {
    faces.push_back({p, area, {0, 0, stress}, region});
  }
};

TEST_F(WssSampling, GivesFacesToTheNearestSurfaceNotTheNearestCentre) {
  const Index small = addCell({0, 0, 0}, 1), large = addCell({10, 0, 0}, 6);
  addFace({3, 0, 0}, 2, 5);  // 2 from the small cell's surface, 1 from the large one's
  addFace({1, 0, 0}, 1, 3);
  const CellShear shear = sampleWss(agents, faces);
  EXPECT_EQ(shear.wss[large], 5);
  EXPECT_EQ(shear.area[large], 2);
  EXPECT_EQ(shear.wss[small], 3);
}

TEST_F(WssSampling, LeavesOutStruts) {
  const Index strut = addCell({1, 0, 0}, 1, true, AgentKind::strut), seen = addCell({9, 0, 0}, 1);
  addFace({1, 0, 0}, 1, 2);
  addFace({9, 0, 0}, 1, 100, SurfaceRegion::strut);
  const CellShear shear = sampleWss(agents, faces);
  EXPECT_EQ(shear.wss[strut], 0);
  EXPECT_EQ(shear.wss[seen], 2);
  EXPECT_EQ(shear.facesGiven, 1U);
}

TEST_F(WssSampling, ChargesNoCellWithTheStressOnTheLaminaBesideIt) {
  const Index lamina = addCell({0, 0, 0}, 1, false, AgentKind::iel), cell = addCell({9, 0, 0}, 1);
  addFace({0, 0, 1}, 3, 100);
  addFace({9, 0, 1}, 1, 2);
  const CellShear shear = sampleWss(agents, faces);
  EXPECT_EQ(shear.wss[cell], 2);
  EXPECT_EQ(shear.wss[lamina], 100);
  EXPECT_EQ(shear.area[lamina], 3);
}

TEST_F(WssSampling, KeepsHiddenCellsWithoutStress) {
  const Index hidden = addCell({0, 0, -9}, 1, false);
  addCell({0, 0, 0}, 1);
  addFace({0, 0, 1}, 1, 2);
  EXPECT_EQ(sampleWss(agents, faces).wss[hidden], 0);
}

TEST_F(WssSampling, FillsCellsWithoutFaceFromTheNearest) {
  addCell({0, 0, 0}, 1);
  const Index without = addCell({0, 0, 3}, 0.1);
  addFace({0, 0, 0.5}, 1, 2);
  addFace({0, 0, -5}, 1, 7);
  const CellShear shear = sampleWss(agents, faces);
  EXPECT_EQ(shear.cellsFilled, 1U);
  EXPECT_EQ(shear.wss[without], 2);
  EXPECT_EQ(shear.area[without], 0);
}

TEST_F(WssSampling, ConservesWhatTheWallCarries) {
  RandomStream random(3, 0, 0, RandomPurpose::packing);
  for (int n = 0; n < 500; ++n) addCell(Vec3(random.uniform(), random.uniform(), 0), 0.02 * random.uniform());
  double carried = 0, area = 0;
  for (int n = 0; n < 5000; ++n) {
    addFace({random.uniform(), random.uniform(), 0.05}, random.uniform(), random.uniform());
    carried += faces.back().area * faces.back().traction.norm(), area += faces.back().area;
  }
  const CellShear shear = sampleWss(agents, faces);
  double received = 0, receivedArea = 0;
  for (Index i = 0; i < agents.size(); ++i)
    received += shear.wss[i] * shear.area[i], receivedArea += shear.area[i];
  EXPECT_NEAR(received, carried, 1e-12 * carried);
  EXPECT_NEAR(receivedArea, area, 1e-12 * area);
}

TEST_F(WssSampling, FindsTheSameCellAsASearchThroughAll) {
  RandomStream random(5, 0, 0, RandomPurpose::packing);
  for (int n = 0; n < 200; ++n)
    addCell({random.uniform(), random.uniform(), random.uniform()}, 0.2 * random.uniform());
  std::vector<double> expected(agents.size(), 0.0);
  for (int n = 0; n < 300; ++n) {
    addFace({random.uniform(), random.uniform(), random.uniform()}, 1, 1);
    Index best = 0;
    double least = std::numeric_limits<double>::max();
    for (Index i = 0; i < agents.size(); ++i) {
      const double d = (agents.position(i) - faces.back().centre).norm() - agents.radius[i];
      if (d < least) least = d, best = i;
    }
    expected[best] += 1;
  }
  EXPECT_EQ(sampleWss(agents, faces).area, expected);
}

TEST_F(WssSampling, GivesNothingWhereThereIsNothing) {
  EXPECT_TRUE(sampleWss(agents, faces).wss.empty());
  addCell({0, 0, 0}, 1);
  EXPECT_EQ(sampleWss(agents, faces).facesGiven, 0U);
}

}  // namespace
}  // namespace restenosis

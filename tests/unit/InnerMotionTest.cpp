#include <gtest/gtest.h>

#include "bridge/flow/foam/InnerMotion.h"
#include "tests/support/Constants.h"
#include "tests/support/TubeMesh.h"

namespace restenosis {
namespace {

using namespace support;

class InnerMotionTest : public ::testing::Test {
 protected:
  PolyMesh mesh = tubeMesh(0.9e-3, 1.2e-3, 24, 4, 6);
  std::vector<PointFreedom> freedom = std::vector<PointFreedom>(mesh.points.size(), PointFreedom::all);
  std::vector<Vec3> displacements = std::vector<Vec3>(mesh.points.size(), Vec3::Zero());

  InnerMotionTest() {
    for (const char* end : {"inlet", "outlet"}) mark(end, PointFreedom::inPlane);
    mark("wall", PointFreedom::given);
  }
  void mark(const char* patch, PointFreedom as) {
    const auto* p = mesh.patch(patch);
    for (std::size_t f = p->start; f < p->start + p->faces; ++f)
      for (const auto i : mesh.face(f)) freedom[i] = as;
  }
};

TEST_F(InnerMotionTest, aRigidMotionAcrossTheVesselIsCarriedEverywhere) {
  const Vec3 shift(3e-6, -2e-6, 0);
  for (std::size_t i = 0; i < freedom.size(); ++i)
    if (freedom[i] == PointFreedom::given) displacements[i] = shift;
  moveInside(mesh, freedom, displacements);
  for (const Vec3& d : displacements) EXPECT_LT((d - shift).norm(), 2e-3 * shift.norm());
}

TEST_F(InnerMotionTest, noneMovesFartherThanTheWallAndTheEndsKeepTheirPlanes) {
  for (std::size_t i = 0; i < freedom.size(); ++i)
    if (freedom[i] == PointFreedom::given) {
      const Vec3& p = mesh.points[i];
      const double bump = std::exp(-50.0 * std::pow(1e3 * p.z() - 0.6, 2));
      displacements[i] = bump * Vec3(-0.02 * p.x(), -0.02 * p.y(), 0.01e-3);
    }
  moveInside(mesh, freedom, displacements);
  double nearWall = 0.0, onAxis = 0.0;
  for (std::size_t i = 0; i < freedom.size(); ++i) {
    EXPECT_LT(displacements[i].norm(), 0.021e-3);
    if (freedom[i] == PointFreedom::inPlane) {
      EXPECT_EQ(displacements[i].z(), 0.0);
    }
    const double r = std::hypot(mesh.points[i].x(), mesh.points[i].y());
    if (r > 0.6e-3 && r < 0.7e-3) nearWall = std::max(nearWall, displacements[i].norm());
    if (r < 1e-12) onAxis = std::max(onAxis, std::hypot(displacements[i].x(), displacements[i].y()));
  }
  EXPECT_GT(nearWall, 0.01e-3);
  EXPECT_LT(onAxis, 1e-7);
}

}  // namespace
}  // namespace restenosis

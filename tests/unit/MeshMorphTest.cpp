#include <gtest/gtest.h>

#include <stdexcept>

#include "bridge/flow/foam/MeshMorph.h"
#include "tests/support/Constants.h"
#include "tests/support/TubeMesh.h"
#include "tests/support/TubeSurface.h"

namespace restenosis {
namespace {

using namespace support;

constexpr int sides = 128;

PolyMesh mesh() { return tubeMesh(vesselRadius, vesselLength, sides, 4, 6); }

double distanceFromAxis(const Vec3& p) { return std::hypot(p.x(), p.y()); }

TEST(MeshMorph, onItsOwnLumenNothingMoves) {
  const auto former = mesh();
  const MeshMorph morph = morphOnto(former, tube(vesselRadius, vesselLength));
  EXPECT_LT(morph.movement, 1e-12);
  EXPECT_LT(morph.departure, 1e-12);
  for (std::size_t i = 0; i < former.points.size(); ++i)
    EXPECT_LT((morph.points[i] - former.points[i]).norm(), 1e-12);
}

TEST(MeshMorph, theWallLiesOnTheNarrowerLumenAndTheEndsStayPlanar) {
  const auto former = mesh();
  constexpr double narrower = 0.89e-3;
  const MeshMorph morph = morphOnto(former, tube(narrower, vesselLength));
  EXPECT_NEAR(morph.movement, vesselRadius - narrower, 1e-8);
  EXPECT_LT(morph.departure, 1e-12);
  const auto exact = tubeMesh(narrower, vesselLength, sides, 4, 6);
  const auto* wall = former.patch("wall");
  for (std::size_t f = wall->start; f < wall->start + wall->faces; ++f)
    for (const auto p : former.face(f)) EXPECT_LT((morph.points[p] - exact.points[p]).norm(), 1e-12);
  for (std::size_t i = 0; i < former.points.size(); ++i) {
    EXPECT_NEAR(morph.points[i].z(), former.points[i].z(), 1e-12);
    // Everything moves inwards, at most as far as the wall
    const double inwards = distanceFromAxis(former.points[i]) - distanceFromAxis(morph.points[i]);
    EXPECT_GE(inwards, -1e-3 * (vesselRadius - narrower));
    EXPECT_LE(inwards, (vesselRadius - narrower) * 1.001);
  }
}

TEST(MeshMorph, whatTheMeshMissesShowsAsDeparture) {
  // A ring stands in from the lumen half way along, between two layers of the mesh's points
  std::vector<ProfilePoint> profile = {{vesselRadius, 0},       {vesselRadius, 0.65e-3},
                                       {0.86e-3, 0.69e-3},      {0.86e-3, 0.71e-3},
                                       {vesselRadius, 0.75e-3}, {vesselRadius, vesselLength}};
  const MeshMorph morph = morphOnto(mesh(), revolve(profile));
  EXPECT_LT(morph.movement, 1e-8);
  EXPECT_GT(morph.departure, 0.03e-3);
}

TEST(MeshMorph, endsMustStayWhereTheyAre) {
  EXPECT_THROW(morphOnto(mesh(), tube(vesselRadius, 1.01 * vesselLength)), std::runtime_error);
}

TEST(MeshMorph, facesTakeTheRegionOfTheLumen) {
  const auto lumen = stentedTube(vesselRadius, vesselLength, 90e-6);
  const Vec3 onWall(vesselRadius, 0, 0.1e-3), onStrut(0.81e-3, 0, 0.6e-3);
  std::vector<WallFace> faces = {{onWall, 1e-10, Vec3::Zero(), SurfaceRegion::strut},
                                 {onStrut, 1e-10, Vec3::Zero(), SurfaceRegion::wall}};
  takeRegions(faces, lumen);
  EXPECT_EQ(faces[0].region, SurfaceRegion::wall);
  EXPECT_EQ(faces[1].region, SurfaceRegion::strut);
}

}  // namespace
}  // namespace restenosis

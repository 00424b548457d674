#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bridge/flow/foam/OGrid.h"
#include "tests/support/Constants.h"
#include "tests/support/TubeSurface.h"

namespace restenosis {
namespace {

using support::revolve;
using support::tube;

constexpr OGridSize someCells{.around = 32, .layers = 6, .along = 10};

Vec3 areaVectorOf(const PolyMesh& mesh, std::size_t face) {
  const auto c = mesh.face(face);
  return 0.5 * (mesh.points[c[2]] - mesh.points[c[0]]).cross(mesh.points[c[3]] - mesh.points[c[1]]);
}

Vec3 middleOf(const PolyMesh& mesh, std::size_t face) {
  Vec3 sum = Vec3::Zero();
  for (const auto p : mesh.face(face)) sum += 0.25 * mesh.points[p];
  return sum;
}

double volumeOf(const PolyMesh& mesh) {
  double volume = 0.0;
  for (std::size_t f = mesh.neighbour.size(); f < mesh.faces(); ++f)
    volume += areaVectorOf(mesh, f).dot(middleOf(mesh, f)) / 3.0;
  return volume;
}

TEST(OGrid, FillsATube) {
  const PolyMesh mesh = oGrid(tube(support::vesselRadius, support::vesselLength), someCells);
  const double area = std::numbers::pi * support::vesselRadius * support::vesselRadius;
  EXPECT_EQ(mesh.cells(), (8u * 8u + 32u * 6u) * 10u);
  EXPECT_NEAR(volumeOf(mesh), area * support::vesselLength, 1e-3 * area * support::vesselLength);
  EXPECT_NEAR(mesh.patchArea("inlet"), area, 1e-3 * area);
  EXPECT_NEAR(mesh.patchArea("outlet"), area, 1e-3 * area);
  const double side = 2 * std::numbers::pi * support::vesselRadius * support::vesselLength;
  EXPECT_NEAR(mesh.patchArea("wall"), side, 5e-3 * side);
}

TEST(OGrid, FacesLookFromTheirOwnerToTheirNeighbour) {
  const PolyMesh mesh = oGrid(tube(support::vesselRadius, support::vesselLength), someCells);
  const auto centres = mesh.cellCentres();
  for (std::size_t f = 0; f < mesh.faces(); ++f) {
    const Vec3 to = f < mesh.neighbour.size() ? centres[mesh.neighbour[f]] : middleOf(mesh, f);
    EXPECT_GT(areaVectorOf(mesh, f).dot(to - centres[mesh.owner[f]]), 0.0) << f;
  }
}

TEST(OGrid, InnerFacesAreInTheOrderThatOpenFoamWants) {
  const PolyMesh mesh = oGrid(tube(support::vesselRadius, support::vesselLength), someCells);
  for (std::size_t f = 0; f < mesh.neighbour.size(); ++f) {
    EXPECT_LT(mesh.owner[f], mesh.neighbour[f]);
    if (f == 0) continue;
    EXPECT_LT(std::pair(mesh.owner[f - 1], mesh.neighbour[f - 1]),
              std::pair(mesh.owner[f], mesh.neighbour[f]));
  }
}

TEST(OGrid, FollowsANarrowing) {
  std::vector<support::ProfilePoint> profile;
  for (int i = 0; i <= 60; ++i) {
    const double z = support::vesselLength * i / 60;
    profile.push_back({support::vesselRadius *
                           (1 - 0.25 * (1 - std::cos(2 * std::numbers::pi * z / support::vesselLength))),
                       z});
  }
  const PolyMesh mesh = oGrid(revolve(profile), {.around = 32, .layers = 6, .along = 40});
  for (std::size_t f = 0; f < mesh.patch("wall")->faces; ++f) {
    const Vec3 middle = middleOf(mesh, mesh.patch("wall")->start + f);
    const double radius =
        support::vesselRadius *
        (1 - 0.25 * (1 - std::cos(2 * std::numbers::pi * middle.z() / support::vesselLength)));
    EXPECT_NEAR(std::hypot(middle.x(), middle.y()), radius, 0.02 * radius);
  }
}

TEST(OGrid, UndercutsAreRefused) {
  const TriSurface brim = revolve({{0.9e-3, 0},
                                   {0.9e-3, 0.6e-3},
                                   {0.7e-3, 0.3e-3},
                                   {0.7e-3, 0.8e-3},
                                   {0.9e-3, 0.9e-3},
                                   {0.9e-3, 1.2e-3}});
  EXPECT_THROW(oGrid(brim, someCells), std::invalid_argument);
}

}  // namespace
}  // namespace restenosis

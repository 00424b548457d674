#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numbers>

#include "bridge/flow/LumenShape.h"
#include "tests/support/LoadedLumenFixture.h"
#include "tests/support/SweptTube.h"
#include "tests/support/TubeSurface.h"

namespace restenosis {
namespace {

using namespace support;
using LoadedLumen = LoadedLumenFixture;

const Vec3 far(3e-3, -2e-3, 7e-3);

TEST_F(LoadedLumen, EndsAreFoundInAnyDirection) {
  for (const Vec3& direction : {Vec3(0, 0, 1), Vec3(1, 2, 3), Vec3(-3, 1, -2)}) {
    const auto motion = motionTo(direction, far);
    const Vec3 origin = motion * Vec3(0, 0, 0), end = motion * Vec3(0, 0, 2e-3);
    // The inlet has the lower coordinate along the axis on which the ends differ most
    Eigen::Index axis = 0;
    direction.cwiseAbs().maxCoeff(&axis);
    const bool forwards = direction[axis] > 0;
    expectEnds(load(moved(tube(vesselRadius, 2e-3), motion)), forwards ? origin : end,
               forwards ? end : origin);
  }
}

TEST_F(LoadedLumen, BentAndStentedTubesHaveTwoEnds) {
  expectEnds(load(bentTube(vesselRadius, 1e-3, 2e-3, 2e-3)), Vec3(0, 0, 0), Vec3(4e-3, 0, 3e-3));
  expectEnds(load(stentedTube(vesselRadius, 2e-3, 0.1e-3)), Vec3(0, 0, 0), Vec3(0, 0, 2e-3));
}

TEST_F(LoadedLumen, OpenEndsAreCapped) {
  const SurfaceRegion wall[] = {SurfaceRegion::wall};
  const TriSurface lumen = load(bentTube(vesselRadius, 1e-3, 2e-3, 1e-3), wall);
  expectEnds(lumen, Vec3(0, 0, 0), Vec3(3e-3, 0, 3e-3));
  const SurfaceRegion oneOpen[] = {SurfaceRegion::wall, SurfaceRegion::inlet};
  expectEnds(load(tube(vesselRadius, 2e-3), oneOpen), Vec3(0, 0, 0), Vec3(0, 0, 2e-3));
}

TEST_F(LoadedLumen, TwoOpenRimsAreTheEndsWhateverElseIsFlat) {
  const TriSurface duct = revolve({{vesselRadius, 0}, {vesselRadius, 2e-3}}, 4);
  const SurfaceRegion wall[] = {SurfaceRegion::wall};
  const TriSurface lumen = load(duct, wall);
  EXPECT_NO_THROW(requireLumenWithPlanarEnds(lumen));
  EXPECT_NEAR((endPlane(lumen, SurfaceRegion::inlet).centre - Vec3(0, 0, 0)).norm(), 0.0, 1e-8);
  EXPECT_NEAR((endPlane(lumen, SurfaceRegion::outlet).centre - Vec3(0, 0, 2e-3)).norm(), 0.0, 1e-8);
  EXPECT_EQ(std::ranges::count(lumen.region, SurfaceRegion::wall), 8);

  EXPECT_SAYS(refusal(duct), "but 6 were found (0 of them open)");
  const SurfaceRegion oneOpen[] = {SurfaceRegion::wall, SurfaceRegion::inlet};
  writeStl(file, duct, 1e-3, oneOpen);
  EXPECT_SAYS(refusalOfFile(), "but 6 were found (1 of them open)");
}

TEST_F(LoadedLumen, NormalsAreTurnedOutwards) {
  TriSurface inside = tube(vesselRadius, 2e-3);
  for (auto& t : inside.triangles) std::swap(t[0], t[1]);
  expectEnds(load(inside), Vec3(0, 0, 0), Vec3(0, 0, 2e-3));
  TriSurface mixed = tube(vesselRadius, 2e-3);
  for (std::size_t t = 0; t < mixed.triangles.size(); t += 3)
    std::swap(mixed.triangles[t][0], mixed.triangles[t][1]);
  expectEnds(load(mixed), Vec3(0, 0, 0), Vec3(0, 0, 2e-3));
}

constexpr std::size_t firstCapTriangle = 2 * 12 * 128;  ///< of `tube`: inlet and outlet in turn

TEST_F(LoadedLumen, HolesInACapAreNoEnds) {
  const TriSurface good = tube(vesselRadius, 2e-3);
  const std::string one = refusalWithout(good, {firstCapTriangle});
  EXPECT_SAYS(one,
              "it has a hole of 3 edges, 0.159 mm wide, around (0.6, 0.015, 0) mm in an end cap of 1.8 mm");
  EXPECT_SAYS(one, "close the hole, or remove the whole cap");
  EXPECT_SAYS(refusalWithout(good, {firstCapTriangle, firstCapTriangle + 2}), "it has a hole of 4 edges");
  EXPECT_SAYS(refusalWithout(good, {firstCapTriangle, firstCapTriangle + 8}),  // they meet in the middle
              "it has 2 holes: one of 3 edges, 0.159 mm wide, around (0.6, 0.015, 0) mm in an end cap of 1.8 "
              "mm, and one of 3 edges, ");
  EXPECT_SAYS(refusalWithout(good, {firstCapTriangle, firstCapTriangle + 1}), "it has 2 holes");
  std::vector<std::size_t> allButOne;
  for (std::size_t t = firstCapTriangle; t < good.triangles.size() - 2; t += 2) allButOne.push_back(t);
  EXPECT_SAYS(refusalWithout(good, allButOne), "it has a hole of 129 edges, 1.79 mm wide");
  const auto motion = motionTo(Vec3(1, 2, 3), far);
  EXPECT_SAYS(refusalWithout(moved(good, motion), {firstCapTriangle}), "in an end cap of 1.8 mm");
}

TEST_F(LoadedLumen, AHoleBesideAnOpenEndIsNoEnd) {
  TriSurface holed = tube(vesselRadius, 2e-3);
  std::erase_if(holed.triangles, [&](const auto& t) { return t[0] == holed.vertices.size() - 2; });
  holed.region.resize(holed.triangles.size());
  EXPECT_EQ(refusal(holed), "accepted");  // without its inlet's cap
  EXPECT_SAYS(refusalWithout(holed, {holed.triangles.size() - 1}), "it has a hole of 3 edges");
}

TEST_F(LoadedLumen, HolesInTheWallAreNoEnds) {
  const TriSurface good = tube(vesselRadius, 2e-3);
  EXPECT_SAYS(refusalWithout(good, {600}), "it has a hole of 3 edges, 0.0685 mm wide, around");
  EXPECT_EQ(refusalWithout(good, {600}).find("cap"), std::string::npos);
  TriSurface blind = revolve({{vesselRadius, 0}, {vesselRadius, 2e-3}, {0.1e-3, 4e-3}}, 32);
  blind.vertices.back().z() += 0.3e-3;  // the outlet is a tip: a hole would be the second end
  EXPECT_SAYS(refusalWithout(blind, {3}), "it has a hole of 3 edges");
}

TEST_F(LoadedLumen, OpenEndsMayBeNarrowAndTapered) {
  const SurfaceRegion wall[] = {SurfaceRegion::wall};
  const double narrow = 0.15 * vesselRadius;
  const TriSurface lumen = load(
      revolve({{narrow, 0}, {vesselRadius, 0.6 * vesselRadius}, {vesselRadius, 2e-3}, {narrow, 3e-3}}), wall);
  EXPECT_NEAR(endDiameter(lumen, SurfaceRegion::inlet), 2 * narrow, 1e-8);
  EXPECT_NEAR(endDiameter(lumen, SurfaceRegion::outlet), 2 * narrow, 1e-8);
  const TriSurface stenosed =
      load(revolve({{vesselRadius, 0}, {narrow, 1e-3}, {narrow, 1.01e-3}, {vesselRadius, 2e-3}}), wall);
  EXPECT_NEAR(endDiameter(stenosed, SurfaceRegion::inlet), 2 * vesselRadius, 1e-8);
}

TEST_F(LoadedLumen, WhatIsWrongIsSaid) {
  const TriSurface good = tube(vesselRadius, 2e-3);
  EXPECT_SAYS(refusal(revolve({{vesselRadius, 0}, {vesselRadius, 2e-3}}, 6)),
              "but 8 were found (0 of them open)");  // a prism's sides are caps

  TriSurface ball = good;  // its outlet drawn out to a cone
  for (Vec3& v : ball.vertices)
    if (v.z() > 1.9e-3) v = v.head<2>().norm() < 1e-6 ? Vec3(0, 0, 4e-3) : v;
  EXPECT_SAYS(refusal(ball), "but 1 was found (0 of them open): 1.8 mm wide around (0, 0, 0) mm");

  EXPECT_SAYS(refusal(good, 1.0), "1800 mm wide");
  EXPECT_SAYS(refusal(good, 1.0), "length unit");
  EXPECT_SAYS(refusal(good, 1e-6), "length unit");

  TriSurface ragged = good;  // without its inlet, the rim of which is not planar
  for (std::size_t t = ragged.triangles.size(); t-- > 0;)
    if (ragged.region[t] == SurfaceRegion::inlet) {
      ragged.triangles.erase(ragged.triangles.begin() + static_cast<std::ptrdiff_t>(t));
      ragged.region.erase(ragged.region.begin() + static_cast<std::ptrdiff_t>(t));
    }
  for (std::size_t v = 0; v < 40; ++v) ragged.vertices[v].z() -= 0.2e-3;
  EXPECT_SAYS(refusal(ragged), "is not planar");

  TriSurface two = good;
  const auto count = static_cast<std::uint32_t>(two.vertices.size());
  for (const Vec3& v : good.vertices) two.vertices.push_back(v + Vec3(0, 0, 5e-3));
  for (const auto& t : good.triangles) two.triangles.push_back({t[0] + count, t[1] + count, t[2] + count});
  two.region.resize(two.triangles.size());
  EXPECT_SAYS(refusal(two), "2 separate pieces");
}

TEST_F(LoadedLumen, WhatPassesThroughItselfIsRefusedWithThePlace) {
  TriSurface spike = tube(0.9e-3, 3e-3, 3);
  const std::size_t sides = 128;
  spike.vertices[sides] += Vec3(-2e-3, 0, 0.5e-3);  // from the middle of one side through the other
  EXPECT_SAYS(refusal(spike), "the lumen surface cannot be used: it passes through itself: ");
  EXPECT_SAYS(refusal(spike), "edges go through other triangles of it, one at (-0.9");
  // A turn and a bit: the end lies in the beginning, or beside it
  const auto coil = [](double aside) {
    std::vector<AxisPoint> axis;
    for (int i = 0; i <= 40; ++i) {
      const double turn = 2.1 * std::numbers::pi * i / 40;
      axis.push_back({Vec3(-2e-3 * std::cos(turn), aside * i / 40, 2e-3 * std::sin(turn)),
                      Vec3(std::sin(turn), 0, std::cos(turn))});
    }
    return sweptTube(axis, 0.7e-3);
  };
  EXPECT_NO_THROW(load(coil(3e-3)));
  EXPECT_SAYS(refusal(coil(0.3e-3)), "it passes through itself");
}

/// A tube in the shape of a T, of square ducts: three open ends.
TriSurface tee(bool open) {
  TriSurface s;
  const auto square = [&](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const auto first = static_cast<std::uint32_t>(s.vertices.size());
    for (const Vec3& v : {a, b, c, d}) s.vertices.push_back(1e-3 * v);
    s.triangles.push_back({first, first + 1, first + 2}),
        s.triangles.push_back({first, first + 2, first + 3});
  };
  for (const auto& [x, z] :
       {std::pair{-1.0, 0.0}, {0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}}) {  // cubes, by a corner
    const Vec3 o(x, 0, z), i(1, 0, 0), j(0, 1, 0), k(0, 0, 1);
    square(o, o + i, o + i + k, o + k), square(o + j, o + j + k, o + j + i + k, o + j + i);
    const bool middle = x == 0 && z == 0, arm = z > 0;
    if (!middle && !arm) square(o + k, o + k + i, o + k + i + j, o + k + j);
    if (!arm) square(o, o + j, o + j + i, o + i);
    if (arm || (x < 0 && !open)) square(o, o + k, o + k + j, o + j);
    if (arm || (x > 0 && !open)) square(o + i, o + i + j, o + i + j + k, o + i + k);
    if (arm && !open) square(o + k, o + k + i, o + k + i + j, o + k + j);
  }
  s.region.resize(s.triangles.size());
  return s;
}

TEST_F(LoadedLumen, OfABifurcationItIsSaidThatOneInletAndOneOutletAreSupported) {
  const std::string open = refusal(tee(true));
  EXPECT_SAYS(open,
              "it needs two planar ends, one inlet and one outlet, but 3 were found (3 of them open): ");
  EXPECT_SAYS(open, "1.128 mm wide around (0.5, 0.5, 2) mm");
  EXPECT_SAYS(open, "Of a bifurcation take one branch; or close the others");
  EXPECT_EQ(open.find("straight"), std::string::npos);
  EXPECT_SAYS(refusal(tee(false)), "were found (0 of them open): ");
  EXPECT_SAYS(refusal(tee(false)), "Of a bifurcation take one branch");
  TriSurface uneven = tee(true);  // one rim is not planar
  for (Vec3& v : uneven.vertices)
    if ((v - Vec3(2e-3, 0, 0)).norm() < 1e-9) v.x() += 0.3e-3;
  EXPECT_SAYS(refusal(uneven), "Of a bifurcation take one branch");
}

TEST_F(LoadedLumen, AThirdFaceBesideNamedEndsIsRemarkedOn) {
  TriSurface side = tee(false);
  for (std::size_t t = 0; t < side.triangles.size(); ++t) {
    const double x = side.centre(t).x();
    if (x < -0.99e-3) side.region[t] = SurfaceRegion::inlet;
    if (x > 1.99e-3) side.region[t] = SurfaceRegion::outlet;
  }
  writeNamedStl(file, side, 1e-3);
  const DescribedLumen lumen = loadDescribedLumen(file, 1e-3);
  ASSERT_EQ(lumen.remarks.size(), 1u);
  EXPECT_SAYS(lumen.remarks[0], "beside the ends that are named, ");
  EXPECT_SAYS(lumen.remarks[0], "1.128 mm wide around (0.5, 0.5, 2) mm, in the solid 'wall'");
}

TEST_F(LoadedLumen, PiecesAndCrowdedEdgesAreSaidWithPlaceAndSize) {
  TriSurface two = tube(vesselRadius, 2e-3);
  const auto count = static_cast<std::uint32_t>(two.vertices.size());
  for (const Vec3& v : {Vec3(3e-3, 0, 0), Vec3(3.5e-3, 0, 0), Vec3(3e-3, 0.5e-3, 0.1e-3)})
    two.vertices.push_back(v);
  two.triangles.push_back({count, count + 1, count + 2});
  two.region.push_back(SurfaceRegion::strut);
  const std::string pieces = refusal(two);
  EXPECT_SAYS(pieces,
              "it consists of 2 separate pieces; a lumen is one. They are 3328 triangles of 16.4 mm2 from "
              "(-0.9, -0.9, 0) to (0.9, 0.9, 2) mm; 1 triangle of 0.1275 mm2 from (3, 0, 0) to (3.5, 0.5, "
              "0.1) mm. Remove those that are not the lumen's wall");
  writeNamedStl(file, two, 1e-3);
  EXPECT_SAYS(refusalOfFile(), "(3.5, 0.5, 0.1) mm, of the solid 'strut'");

  TriSurface fin = tube(vesselRadius, 2e-3);
  fin.vertices.emplace_back(3e-3, 0, 0);
  fin.triangles.push_back({0, 1, count});
  fin.region.push_back(SurfaceRegion::wall);
  EXPECT_SAYS(refusal(fin),
              "an edge has more than two triangles: one of 0.0442 mm at (0.9, 0.022, 0) mm. Parts of it");
}

TEST_F(LoadedLumen, WhatEnclosesNothingIsFlat) {
  TriSurface flat;
  flat.vertices = {{0, 0, 0}, {1e-3, 0, 0}, {0, 1e-3, 0}, {1e-3, 1e-3, 0}};
  flat.triangles = {{0, 1, 2}};
  flat.region.resize(1);
  EXPECT_SAYS(refusal(flat), "it encloses no lumen: it is flat, 1 triangle");
  flat.triangles.push_back({1, 3, 2});
  flat.region.resize(2);
  EXPECT_SAYS(refusal(flat), "it encloses no lumen: it is flat, 2 triangles in one plane");
  flat.triangles = {{0, 0, 0}};
  flat.region.resize(1);
  EXPECT_SAYS(refusal(flat), "holds no triangles that have an area");
}

TEST_F(LoadedLumen, AVertexFarFromAllOthersIsNamed) {
  for (const double z : {3e35, 30.0}) {
    TriSurface astray = tube(vesselRadius, 2e-3);
    astray.vertices[5 * 128].z() = z;  // in triangle 1026 first
    EXPECT_SAYS(refusal(astray),
                z > 1e3 ? ", 0, 3e+38) in triangle 1026 of 3328" : ", 0, 30000) in triangle");
    EXPECT_SAYS(refusalOfFile(), "has a vertex far from all others");
  }
}

TEST_F(LoadedLumen, AsciiFilesKeepTheirPlaceFarFromTheOrigin) {
  const double away = 10.0;  // where single precision tells 1 um apart
  const TriSurface good = tube(vesselRadius, 2e-3);
  writeNamedStl(file, moved(good, motionTo(Vec3(0, 0, 1), Vec3(away, away, 0))), 1e-3);
  const TriSurface lumen = loadLumen(file, 1e-3);
  double departure = 0.0;
  for (std::size_t t = 0; t < lumen.triangles.size(); ++t)
    if (lumen.region[t] == SurfaceRegion::wall)
      for (const auto v : lumen.triangles[t])
        departure = std::max(departure, std::abs((lumen.vertices[v] - Vec3(away, away, 0)).head<2>().norm() -
                                                 good.vertices[0].head<2>().norm()));
  EXPECT_LT(departure, 1e-7);  // nine digits; in single precision it is 5e-7
}

TEST_F(LoadedLumen, WhatLiesTooFarFromTheOriginIsRefused) {
  for (const double away : {100.0, 1e4, 1e6}) {  // [m]
    const TriSurface distant = moved(tube(vesselRadius, 2e-3), motionTo(Vec3(1, 2, 3), Vec3(away, 0, 0)));
    EXPECT_SAYS(refusal(distant), "lies too far from the origin: single precision");
    writeNamedStl(file, distant, 1e-3);
    EXPECT_SAYS(refusalOfFile(), "lies too far from the origin");
  }
}

TEST_F(LoadedLumen, FilesThatAreNoSurfacesAreNamed) {
  EXPECT_SAYS(refusalOfFile(), "cannot be read: No such file or directory");
  writeText(file, "solid nothing\nendsolid nothing\n");
  EXPECT_SAYS(refusalOfFile(), "holds no triangles");
  TriSurface broken = tube(vesselRadius, 2e-3);
  broken.vertices[7].x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_SAYS(refusal(broken), "not a finite number");
  writeNamedStl(file, broken, 1e-3);
  EXPECT_SAYS(refusalOfFile(), "lumen.stl:");
  EXPECT_SAYS(refusalOfFile(), "'nan' is not a finite number");
}

}  // namespace
}  // namespace restenosis

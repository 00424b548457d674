#include <gtest/gtest.h>

#include <limits>

#include "Constants.h"
#include "LoadedLumen.h"
#include "LumenShape.h"
#include "StlFile.h"
#include "SweptTube.h"
#include "TemporaryFolder.h"
#include "TubeSurface.h"

namespace restenosis {
namespace {

using namespace support;

const Vec3 far(3e-3, -2e-3, 7e-3);

class LoadedLumen : public ::testing::Test {
 protected:
  /// Writes a surface without names, in mm, and loads it.
  TriSurface load(const TriSurface& surface, std::span<const SurfaceRegion> regions = {}) const {
    writeStl(file, surface, 1e-3, regions);
    return loadLumen(file, 1e-3);
  }
  std::string refusal(const TriSurface& surface, double metresPerUnit = 1e-3) const {
    writeStl(file, surface, 1e-3);
    return refusalOfFile(metresPerUnit);
  }
  std::string refusalOfFile(double metresPerUnit = 1e-3) const {
    try {
      loadLumen(file, metresPerUnit);
      return "accepted";
    } catch (const std::runtime_error& error) {
      return error.what();
    }
  }
  void expectEnds(const TriSurface& lumen, const Vec3& inlet, const Vec3& outlet) const {
    EXPECT_NO_THROW(requireLumenWithPlanarEnds(lumen));
    EXPECT_NEAR((endPlane(lumen, SurfaceRegion::inlet).centre - inlet).norm(), 0.0, 1e-8);
    EXPECT_NEAR((endPlane(lumen, SurfaceRegion::outlet).centre - outlet).norm(), 0.0, 1e-8);
    EXPECT_NEAR(endDiameter(lumen, SurfaceRegion::inlet), 2 * vesselRadius, 1e-8);
  }

  TemporaryFolder folder;
  std::filesystem::path file = folder / "lumen.stl";
};

#define EXPECT_SAYS(text, part) EXPECT_NE((text).find(part), std::string::npos) << (text)

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

TEST_F(LoadedLumen, NormalsAreTurnedOutwards) {
  TriSurface inside = tube(vesselRadius, 2e-3);
  for (auto& t : inside.triangles) std::swap(t[0], t[1]);
  expectEnds(load(inside), Vec3(0, 0, 0), Vec3(0, 0, 2e-3));
  TriSurface mixed = tube(vesselRadius, 2e-3);
  for (std::size_t t = 0; t < mixed.triangles.size(); t += 3)
    std::swap(mixed.triangles[t][0], mixed.triangles[t][1]);
  expectEnds(load(mixed), Vec3(0, 0, 0), Vec3(0, 0, 2e-3));
}

TEST_F(LoadedLumen, NamesOfSolidsDecide) {
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

TEST_F(LoadedLumen, WhatIsWrongIsSaid) {
  const TriSurface good = tube(vesselRadius, 2e-3);
  TriSurface hole = good;
  hole.triangles.erase(hole.triangles.begin() + 600), hole.region.pop_back();
  EXPECT_SAYS(refusal(hole), "but 3 were found (1 of them open)");

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

TEST_F(LoadedLumen, FilesThatAreNoSurfacesAreNamed) {
  EXPECT_SAYS(refusalOfFile(), "is not a file");
  writeText(file, "solid nothing\nendsolid nothing\n");
  EXPECT_SAYS(refusalOfFile(), "holds no triangles");
  TriSurface broken = tube(vesselRadius, 2e-3);
  broken.vertices[7].x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_SAYS(refusal(broken), "not a finite number");
  writeNamedStl(file, broken, 1e-3);
  EXPECT_NE(refusalOfFile(), "accepted");
}

}  // namespace
}  // namespace restenosis

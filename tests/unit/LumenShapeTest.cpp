#include <gtest/gtest.h>

#include <limits>
#include <numbers>
#include <stdexcept>

#include "bridge/flow/LumenShape.h"
#include "tests/support/AnnularTube.h"
#include "tests/support/Constants.h"
#include "tests/support/TubeSurface.h"

namespace restenosis {
namespace {

using namespace support;

TEST(LumenShape, tubeHasItsVolumeAndEnds) {
  const TriSurface lumen = support::tube(0.9e-3, 1.2e-3);
  EXPECT_NO_THROW(requireLumen(lumen));
  EXPECT_NEAR(enclosedVolume(lumen) / (pi * 0.81e-6 * 1.2e-3), 1.0, 1e-12);
  const LumenEnd outlet = lumenEnd(lumen, SurfaceRegion::outlet);
  EXPECT_NEAR(outlet.area / (pi * 0.81e-6), 1.0, 1e-12);
  EXPECT_DOUBLE_EQ(outlet.z, 1.2e-3);
  EXPECT_NEAR((outlet.centre - Vec3(0, 0, 1.2e-3)).norm(), 0.0, 1e-12);
}

TEST(LumenShape, crossSectionsHaveTheirCentroids) {
  TriSurface oblique = support::tube(0.9e-3, 1.2e-3);
  for (Vec3& v : oblique.vertices) v += Vec3(2e-3 + 0.5 * v.z(), -v.z(), 0);
  const double z[] = {0.1e-3, 0.77e-3};
  const auto sections = crossSections(oblique, z);
  for (int i = 0; i < 2; ++i) {
    EXPECT_NEAR(sections[i].area / (pi * 0.81e-6), 1.0, 1e-12);
    EXPECT_LT((sections[i].centre - Vec3(2e-3 + 0.5 * z[i], -z[i], z[i])).norm(), 1e-12);
  }
}

TEST(LumenShape, crossSectionsAndRimsHaveTheirLengths) {
  const TriSurface lumen = annularTube(0.9e-3, 0.4e-3, 1e-3);
  const double z[] = {0.1e-3, 0.5e-3};
  const double exact = 2 * pi * 1.3e-3;
  for (const CrossSection& section : crossSections(lumen, z))
    EXPECT_NEAR(section.perimeter / exact, 1.0, 1e-3);
  double length = 0.0;
  const auto rim = endRim(lumen, SurfaceRegion::outlet);
  for (const auto& [a, b] : rim) length += (lumen.vertices[b] - lumen.vertices[a]).norm();
  EXPECT_EQ(rim.size(), 2u * 96u);
  EXPECT_NEAR(length / exact, 1.0, 1e-3);
}

TEST(LumenShape, crossSectionsOfACone) {
  const TriSurface cone = support::revolve({{1e-3, 0.0}, {0.5e-3, 1e-3}});
  const std::vector<double> z = {0.0, 0.25e-3, 0.5e-3, 0.9e-3};
  const auto areas = crossSectionAreas(cone, z);
  for (std::size_t i = 1; i < z.size(); ++i) {
    const double radius = 1e-3 - 0.5 * z[i];
    // Quadrilaterals of the cone are split into triangles whose diagonals cut the corners of the contour
    EXPECT_NEAR(areas[i] / (pi * radius * radius), 1.0, 1e-3) << z[i];
  }
}

TEST(LumenShape, damageIsNamed) {
  const auto messageOf = [](TriSurface lumen, auto damage) -> std::string {
    damage(lumen);
    try {
      requireLumen(lumen);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  const TriSurface good = support::tube(1e-3, 1e-3);
  EXPECT_NE(
      messageOf(good, [](TriSurface& s) { s.triangles.erase(s.triangles.begin() + 9), s.region.pop_back(); })
          .find("not closed: 3 edges"),
      std::string::npos);
  EXPECT_NE(
      messageOf(good, [](TriSurface& s) { s.vertices[7].x() = std::numeric_limits<double>::quiet_NaN(); })
          .find("not a number"),
      std::string::npos);
  EXPECT_NE(messageOf(good,
                      [](TriSurface& s) {
                        for (auto& t : s.triangles) std::swap(t[0], t[1]);
                      })
                .find("normals"),
            std::string::npos);
  EXPECT_NE(messageOf(good,
                      [](TriSurface& s) {
                        for (auto& r : s.region) r = SurfaceRegion::wall;
                      })
                .find("no inlet"),
            std::string::npos);
  EXPECT_NE(messageOf(good, [](TriSurface& s) { s.vertices[0].z() = 1e-4; }).find("plane of constant z"),
            std::string::npos);
  EXPECT_NE(
      messageOf(good, [](TriSurface& s) { s.triangles.clear(), s.region.clear(); }).find("no triangles"),
      std::string::npos);
}

}  // namespace
}  // namespace restenosis

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include "bridge/surface/WallOutwards.h"
#include "tests/support/Constants.h"
#include "tissue/vessel/Cylindrical.h"
#include "tissue/vessel/SurfaceFromAxis.h"

namespace restenosis {
namespace {

using namespace support;
using std::numbers::pi;

constexpr double length = 0.6e-3, thickness = 0.12e-3;

/// The closed surface of a tube along z whose section is scaled and shifted from ring to ring.
template <class Radius, class Centre>
TriSurface tubeOf(Radius&& radiusAt, Centre&& centreAt, int rings = 31, int sides = 128) {
  TriSurface s;
  for (int k = 0; k < rings; ++k)
    for (int i = 0; i < sides; ++i) {
      const double angle = 2 * pi * i / sides, z = length * k / (rings - 1);
      s.vertices.push_back(centreAt(z) + toCartesian({radiusAt(angle, z), angle, z}));
    }
  const auto add = [&s](std::uint32_t a, std::uint32_t b, std::uint32_t c, SurfaceRegion region) {
    s.triangles.push_back({a, b, c});
    s.region.push_back(region);
  };
  for (int k = 0; k + 1 < rings; ++k)
    for (int i = 0; i < sides; ++i) {
      const std::uint32_t a = k * sides + i, b = k * sides + (i + 1) % sides;
      add(a, b, b + sides, SurfaceRegion::wall);
      add(a, b + sides, a + sides, SurfaceRegion::wall);
    }
  return s;
}
const auto onAxis = [](double) { return Vec3(0, 0, 0); };

VesselParameters vessel() {
  VesselParameters v;
  v.length = length;
  v.wallThickness = thickness;
  v.cellRadius = r;
  return v;
}

double ellipse(double angle) {
  constexpr double a = 0.6e-3, b = 0.4e-3;
  return a * b / std::hypot(b * std::cos(angle), a * std::sin(angle));
}

std::string refusal(const TriSurface& lumen) {
  try {
    wallOutwards(lumen, vessel());
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(WallOutwards, AroundACylinderIsThatOfTheVessel) {
  constexpr double radius = 0.5e-3;
  const auto lumen = tubeOf([](double, double) { return radius; }, onAxis, 31, 512);
  VesselParameters v = vessel();
  const WallShape built = wallOutwards(lumen, v);
  v.lumenDiameter = 2 * radius;
  const WallShape expected = cylindricalShape(v);
  for (const double angle : {-3.0, 0.1, 1.7}) {
    const Vec3 place = toCartesian({1e-3, angle, 0.3 * length});
    EXPECT_NEAR(built.iel.at(place), expected.iel.at(place), 2e-8);
    EXPECT_NEAR(built.inner.at(place), expected.inner.at(place), 2e-8);
    EXPECT_NEAR(built.outer.at(place), expected.outer.at(place), 2e-8);
    EXPECT_NEAR(built.eel.at(place), expected.eel.at(place), 2e-8);
    EXPECT_LT((built.eel.normalAt(place) - radialAt(place)).norm(), 1e-3);
  }
  EXPECT_NEAR(built.ielArea / expected.ielArea, 1, 1e-3);
  EXPECT_NEAR(built.eelArea / expected.eelArea, 1, 1e-3);
  EXPECT_NEAR(built.volume / expected.volume, 1, 1e-3);
}

TEST(WallOutwards, AroundAnEllipseTheWallIsEquallyThick) {
  const auto lumen = tubeOf([](double angle, double) { return ellipse(angle); }, onAxis);
  const WallShape built = wallOutwards(lumen, vessel());
  for (const double angle : {-2.9, -0.8, 0.3, 1.5}) {
    const Vec3 out = toCartesian({1, angle, 0.5 * length});
    const Vec3 place = toCartesian({built.eel.at(out), angle, 0.5 * length});
    double nearest = 1;
    for (int i = 0; i < 20000; ++i) {
      const double around = 2 * pi * i / 20000;
      nearest = std::min(nearest, (place - toCartesian({ellipse(around), around, 0.5 * length})).norm());
    }
    EXPECT_NEAR(nearest, thickness - r, 0.05 * r) << angle << ": linear between rays 2 r apart";
  }
}

TEST(WallOutwards, OfAConeIsThickAcrossItsSide) {
  constexpr double slope = 0.5;
  const auto radius = [](double, double z) { return 0.4e-3 + slope * z; };
  const WallShape built = wallOutwards(tubeOf(radius, onAxis, 31, 512), vessel());
  const Vec3 place(1e-3, 0, 0.5 * length);
  EXPECT_NEAR(built.eel.at(place) - radius(0, place.z()), (thickness - r) * std::hypot(1, slope), 2e-7);
  const Vec3 normal = Vec3(1, 0, -slope).normalized();
  EXPECT_LT((built.eel.normalAt(place) - normal).norm(), 0.01);
  EXPECT_NEAR(built.eel.areaElementAt(place), built.eel.at(place) * std::hypot(1, slope), 1e-5);
}

TEST(WallOutwards, PlanesAndRaysThroughCornersMeetTheSide) {
  // Rings of corners are in planes of the grid but for rounding, and some corners on its rays
  auto star =
      tubeOf([](double angle, double) { return 0.3e-3 + 0.1e-3 * std::cos(5 * angle); }, onAxis, 13, 96);
  std::mt19937 random;
  const auto rounding = [&random] { return static_cast<double>(random()) / std::mt19937::max() - 0.5; };
  for (Vec3& v : star.vertices) v += Vec3(1e-14 * rounding(), 1e-14 * rounding(), 1e-17 * rounding());
  const RadiusMap seen = lumenFromAxis(star, length / 40);
  for (const double radius : seen.values()) {
    EXPECT_GT(radius, 0.199e-3);
    EXPECT_LT(radius, 0.401e-3);
  }
}

TEST(WallOutwards, NeedsAnAxisThatSeesAllOfTheLumen) {
  const auto beside = [](double z) { return Vec3(1.2e-3 * z / length, 0, 0); };
  EXPECT_NE(refusal(tubeOf([](double, double) { return 0.5e-3; }, beside))
                .find("along the axis it is not in the lumen"),
            std::string::npos);
  const auto lobed = [](double angle, double) { return 0.5e-3 * (1 + 0.9 * std::cos(2 * angle)); };
  EXPECT_EQ(refusal(tubeOf(lobed, onAxis)), "") << "seen from the axis, however thin its waist";
  // A bulge that hangs over: rings that go back along z
  TriSurface folded = tubeOf([](double, double z) { return 0.3e-3 + 0.3 * z; }, onAxis);
  for (Vec3& vertex : folded.vertices)
    if (vertex.z() > 0.45 * length && vertex.z() < 0.55 * length) vertex.z() -= 0.2 * length;
  EXPECT_NE(refusal(folded).find("the lumen's side folds back"), std::string::npos) << refusal(folded);
}

}  // namespace
}  // namespace restenosis

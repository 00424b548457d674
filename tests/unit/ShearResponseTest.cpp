#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bridge/sampling/ShearResponse.h"
#include "tests/support/Constants.h"

namespace restenosis {
namespace {

using namespace support;

using Drive = FlowConditions::Drive;

/// The lumen of a tube whose wall is raised by `height` (z, angle).
template <class Height>
RadialMap raised(const Height& height) {
  return RadialMap(LumenField::fromFunction(
      [&](const Vec3& p) {
        return vesselRadius - height(p.z(), std::atan2(p.y(), p.x())) - std::hypot(p.x(), p.y());
      },
      vesselLength, 1.1e-3, 15e-6));
}

const RadialMap& plain() {
  static const RadialMap map = raised([](double, double) { return 0.0; });
  return map;
}

Vec3 onWall(double z, double angle) {
  return {vesselRadius * std::cos(angle), vesselRadius * std::sin(angle), z};
}

TEST(ShearResponse, nothingMovedNothingChanges) {
  const ShearResponse response(plain(), plain(), Drive::flowRate, 0);
  EXPECT_DOUBLE_EQ(response.factorAt(onWall(0.3e-3, 1)), 1);
}

TEST(ShearResponse, uniformNarrowingIsThatOfATube) {
  const RadialMap narrow = raised([](double, double) { return 2e-6; });
  const double x = 2e-6 / vesselRadius;
  EXPECT_NEAR(ShearResponse(plain(), narrow, Drive::flowRate, 0).factorAt(onWall(0.6e-3, 0)), 1 + 3 * x,
              0.02 * x);
  EXPECT_NEAR(ShearResponse(plain(), narrow, Drive::pressureGradient, 0).factorAt(onWall(0.6e-3, 0)), 1 - x,
              0.02 * x);
}

TEST(ShearResponse, wavesAlongTheFlowCountTwiceThoseAroundTheVessel) {
  const double height = 1e-6;
  const double along = 8 * 2 * pi / vesselLength;
  const RadialMap ripples = raised([&](double z, double) { return height * std::cos(along * z); });
  const ShearResponse atRipples(plain(), ripples, Drive::flowRate, 0);
  EXPECT_NEAR(atRipples.factorAt(onWall(vesselLength / 2, 0.7)) - 1, 2 * along * height,
              0.05 * along * height);
  const double trough = vesselLength / 2 + vesselLength / 16;
  EXPECT_NEAR(1 / atRipples.factorAt(onWall(trough, 0.7)) - 1, 2 * along * height, 0.05 * along * height);

  const double around = 30 / vesselRadius;
  const RadialMap flutes = raised([&](double, double angle) { return height * std::cos(30 * angle); });
  const ShearResponse atFlutes(plain(), flutes, Drive::flowRate, 0);
  EXPECT_NEAR(atFlutes.factorAt(onWall(0.4e-3, 0)) - 1, around * height, 0.05 * around * height);
}

TEST(ShearResponse, shortWavesAreSmoothedAway) {
  const double along = 20 * 2 * pi / vesselLength, cutoff = 2 / along;
  const RadialMap ripples = raised([&](double z, double) { return 1e-6 * std::cos(along * z); });
  const ShearResponse sharp(plain(), ripples, Drive::flowRate, 0);
  const ShearResponse smooth(plain(), ripples, Drive::flowRate, cutoff);
  const Vec3 crest = onWall(vesselLength / 2, 0);
  EXPECT_NEAR((smooth.factorAt(crest) - 1) / (sharp.factorAt(crest) - 1), std::exp(-2), 0.01);
}

TEST(ShearResponse, staysPositiveHoweverDeepTheHollow) {
  const RadialMap hollow =
      raised([](double z, double) { return -0.15e-3 * std::exp(-std::pow((z - 0.6e-3) / 50e-6, 2)); });
  const ShearResponse response(plain(), hollow, Drive::flowRate, 15e-6);
  const double factor = response.factorAt(onWall(0.6e-3, 0));
  EXPECT_GT(factor, 0);
  EXPECT_LT(factor, 0.5);
}

TEST(ShearResponse, refusesMapsThatDoNotMatch) {
  const auto field = LumenField::fromFunction(
      [](const Vec3& p) { return vesselRadius - std::hypot(p.x(), p.y()); }, vesselLength, 1.1e-3, 15e-6);
  EXPECT_THROW(ShearResponse(plain(), RadialMap(field, 90), Drive::flowRate, 0), std::invalid_argument);
}

}  // namespace
}  // namespace restenosis

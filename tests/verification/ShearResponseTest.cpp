#include <gtest/gtest.h>

#include <string>

#include "bridge/flow/foam/FoamBackend.h"
#include "bridge/sampling/ShearResponse.h"
#include "tests/support/FlowSupport.h"
#include "tests/support/OpenFoamPresent.h"
#include "tests/support/TemporaryFolder.h"
#include "tests/support/TubeSurface.h"

namespace restenosis {
namespace {

using namespace support;

/// Waves on the wall of a tube, 10 um high, that fade towards its ends.
struct Waves {
  std::string name;
  double along;   ///< wavelength along the vessel [m]; 0: none
  double around;  ///< waves around the vessel
  double limit;   ///< error with the update over that without it

  double height(const Vec3& p) const {
    const double z = p.z() - 0.5 * vesselLength, fade = std::cos(std::numbers::pi * z / vesselLength);
    const double phase =
        (along > 0 ? 2 * std::numbers::pi * z / along : 0) + around * std::atan2(p.y(), p.x());
    return 10e-6 * fade * fade * std::cos(phase);
  }
};
void PrintTo(const Waves& waves, std::ostream* out) { *out << waves.name; }

TriSurface wavyTube(const Waves& waves) {
  TriSurface surface = tube(vesselRadius, vesselLength, 120);
  for (Vec3& v : surface.vertices) {
    const double radius = v.head<2>().norm();
    if (radius > 0.5 * vesselRadius) v.head<2>() *= 1 - waves.height(v) / radius;
  }
  return surface;
}

template <class Height>
RadialMap mapOf(const Height& height) {
  return RadialMap(LumenField::fromFunction(
      [&](const Vec3& p) { return vesselRadius - height(p) - std::hypot(p.x(), p.y()); }, vesselLength,
      1.1e-3, 10e-6));
}

struct ShearResponseOfWaves : ::testing::TestWithParam<Waves> {};

/// The stress of the straight tube brought up to date, against the flow solved in the wavy one. What remains
/// is the waves' second order and the fluid's inertia, which shifts crests of stress upstream.
TEST_P(ShearResponseOfWaves, followsTheSolvedFlow) {
  RESTENOSIS_NEEDS_OPENFOAM();
  const Waves& waves = GetParam();
  const TemporaryFolder scratch;
  FoamBackend backend(FoamSettings::forFidelity("standard"));
  const auto solved = backend.solve(wavyTube(waves), vesselConditions(), scratch / "case");
  const ShearResponse response(mapOf([](const Vec3&) { return 0.0; }),
                               mapOf([&](const Vec3& p) { return waves.height(p); }),
                               FlowConditions::Drive::flowRate, 15e-6);
  const double from = 0.2e-3, to = vesselLength - 0.2e-3;
  const auto old = stressError(solved, vesselStress(), from, to);
  const auto updated = stressError(
      solved, [&](const Vec3& at) { return vesselStress() * response.factorAt(at); }, vesselStress(), from,
      to);
  RecordProperty("old", std::to_string(old.l2));
  RecordProperty("updated", std::to_string(updated.l2));
  EXPECT_LT(updated.l2, waves.limit * old.l2);
}

INSTANTIATE_TEST_SUITE_P(Verification, ShearResponseOfWaves,
                         ::testing::Values(Waves{"along", 300e-6, 0, 0.35},
                                           Waves{"oblique", 500e-6, 10, 0.35}),
                         [](const auto& waves) { return waves.param.name; });

}  // namespace
}  // namespace restenosis

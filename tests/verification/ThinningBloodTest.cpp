#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bridge/flow/TubeFlow.h"
#include "bridge/flow/foam/FoamBackend.h"
#include "bridge/flow/lbm/LbmBackend.h"
#include "tests/support/FlowSupport.h"
#include "tests/support/OpenFoamPresent.h"
#include "tests/support/TemporaryFolder.h"
#include "tests/support/TubeSurface.h"
#include "tests/support/VesselFlowChecks.h"

namespace restenosis {
namespace {

using namespace support;

/// Of the stress on the wall, relative: mean, L2, and of the pressure drop.
constexpr double meanError = 0.015, l2Error = 0.02, dropError = 0.03;

/// Developed flow with a closed form.
struct ThinTube {
  ViscosityLaw law;
  double wallStress;  ///< over the density [m^2/s^2]
  double flowRate;    ///< [m^3/s]

  FlowConditions conditions(FlowConditions::Drive drive) const {
    FlowConditions c = vesselConditions();
    c.drive = drive;
    c.flowRate = flowRate;
    c.pressureGradient = gradient();
    c.kinematicViscosity = law(law.shearRateAt(wallStress));
    c.thinning = law;
    return c;
  }
  /// [Pa/m]
  double gradient() const { return 2 * vesselConditions().density * wallStress / vesselRadius; }
};

constexpr double cube = std::numbers::pi * vesselRadius * vesselRadius * vesselRadius;

/// A power law for all shear rates that matter: Carreau's law bends at a hundredth of the wall's.
ThinTube powerLaw() {
  const double wallRate = 600, n = 0.5;
  const ViscosityLaw law{.kind = ViscosityLaw::Kind::carreau,
                         .zeroShear = 4e-5,
                         .infiniteShear = 1e-12,
                         .time = 100 / wallRate,
                         .index = n};
  return {law, law.zeroShear * std::pow(law.time, n - 1) * std::pow(wallRate, n),
          cube * wallRate * n / (3 * n + 1)};
}

/// A plug of a quarter of the radius.
ThinTube casson() {
  const ViscosityLaw law{
      .kind = ViscosityLaw::Kind::casson, .zeroShear = 4e-4, .infiniteShear = 3.5e-6, .yieldStress = 4e-4};
  const double x = 0.25, stress = law.yieldStress / x;
  return {law, stress,
          cube * stress / (4 * law.infiniteShear) *
              (1 - 16.0 / 7 * std::sqrt(x) + 4.0 / 3 * x - std::pow(x, 4) / 21)};
}

void expectClosedForm(FlowBackend& backend, const ThinTube& exact, FlowConditions::Drive drive) {
  const TemporaryFolder scratch;
  const auto s =
      backend.solve(tube(vesselRadius, vesselLength), exact.conditions(drive), scratch.path() / "case");
  const double density = vesselConditions().density;
  const auto error = stressError(s, density * exact.wallStress, endMargin, vesselLength - endMargin);
  EXPECT_LT(std::abs(error.mean), meanError);
  EXPECT_LT(error.l2, l2Error);
  EXPECT_NEAR(s.pressureDrop / (exact.gradient() * vesselLength), 1, dropError);
  ::testing::Test::RecordProperty("l2", std::to_string(error.l2));
}

void expectClosedForms(FlowBackend& backend) {
  for (const ThinTube& exact : {powerLaw(), casson()})
    for (const auto drive : {FlowConditions::Drive::flowRate, FlowConditions::Drive::pressureGradient}) {
      SCOPED_TRACE(exact.law.kind == ViscosityLaw::Kind::casson ? "Casson" : "power law");
      SCOPED_TRACE(drive == FlowConditions::Drive::flowRate ? "flow rate" : "pressure gradient");
      expectClosedForm(backend, exact, drive);
    }
}

TEST(ThinningBlood, OpenFoamHasTheClosedForms) {
  RESTENOSIS_NEEDS_OPENFOAM();
  FoamBackend backend(FoamSettings::forFidelity("draft"));
  expectClosedForms(backend);
}

TEST(ThinningBlood, TheLatticeHasTheClosedForms) {
  LbmSettings settings;
  settings.dx = 60e-6;
  LbmBackend backend(settings);
  expectClosedForms(backend);
}

}  // namespace
}  // namespace restenosis

#include <gtest/gtest.h>

#include <cmath>

#include "bridge/flow/BentVessel.h"
#include "bridge/flow/LumenFrame.h"
#include "bridge/flow/StraightEnds.h"
#include "bridge/flow/foam/FoamBackend.h"
#include "tests/support/FlowSupport.h"
#include "tests/support/OpenFoamPresent.h"
#include "tests/support/TemporaryFolder.h"
#include "tests/support/TubeSurface.h"
#include "tests/support/VesselFlowChecks.h"

namespace restenosis {
namespace {

using namespace support;

/// Mean stress over a vessel about the angle [rad], a sixth of the way around, without the ends.
double stressAbout(const FlowSolution& s, double angle) {
  double area = 0, sum = 0;
  for (const WallFace& face : s.wall) {
    if (face.centre.z() < endMargin || face.centre.z() > vesselLength - endMargin) continue;
    const double off =
        std::remainder(std::atan2(face.centre.y(), face.centre.x()) - angle, 2 * std::numbers::pi);
    if (std::abs(off) > std::numbers::pi / 6) continue;
    area += face.area, sum += face.area * face.traction.z();
  }
  return sum / area;
}

std::unique_ptr<FlowBackend> bent(double radius, double ends) {
  auto axis = std::make_shared<const Centreline>(Centreline::arc(radius, -ends, vesselLength + ends));
  auto backend = std::make_unique<BentVessel>(
      std::make_unique<AnyDirection>(std::make_unique<FoamBackend>(FoamSettings::forFidelity("draft"))),
      std::move(axis));
  return std::make_unique<StraightEnds>(std::move(backend), ends, 20);
}

constexpr double inner = std::numbers::pi / 2, outer = -inner;

TEST(BentVessel, ThatIsHardlyBentHasPoiseuillesStress) {
  RESTENOSIS_NEEDS_OPENFOAM();
  const TemporaryFolder scratch;
  const auto s =
      bent(10, 0.6e-3)->solve(tube(vesselRadius, vesselLength), vesselConditions(), scratch.path() / "case");
  const auto error = stressError(s, vesselStress(), endMargin, vesselLength - endMargin);
  EXPECT_LT(std::abs(error.mean), 0.015);
  EXPECT_LT(error.l2, 0.02);
  EXPECT_NEAR(stressAbout(s, inner) / stressAbout(s, outer), 1, 0.01);
}

/// Without inertia the axial velocity in a bend is, to first order, that of a straight tube times
/// 1 + 3/4 (r / radius) cos of the angle from the inner side (Dean 1927): the pressure falls as much along
/// the shorter way. So is the stress. The Dean number here is 1.3.
TEST(BentVessel, HasTheStressOfSlowFlowInABend) {
  RESTENOSIS_NEEDS_OPENFOAM();
  const TemporaryFolder scratch;
  FlowConditions slow = vesselConditions();
  slow.flowRate /= 20;
  const double radius = 10e-3;
  const auto s = bent(radius, 1.8e-3)->solve(tube(vesselRadius, vesselLength), slow, scratch.path() / "case");
  const double straight = vesselStress() / 20;
  const double share = 0.75 * vesselRadius / radius * 3 / std::numbers::pi;  // mean cosine of a sixth
  EXPECT_NEAR(stressAbout(s, inner) / straight, 1 + share, 0.02);
  EXPECT_NEAR(stressAbout(s, outer) / straight, 1 - share, 0.02);
}

/// At the thesis's flow inertia carries the fast blood outwards.
TEST(BentVessel, HasMoreStressOnItsOuterSide) {
  RESTENOSIS_NEEDS_OPENFOAM();
  const TemporaryFolder scratch;
  const auto s =
      bent(10e-3, 3e-3)->solve(tube(vesselRadius, vesselLength), vesselConditions(), scratch.path() / "case");
  EXPECT_GT(stressAbout(s, outer), 1.1 * stressAbout(s, inner));
}

}  // namespace
}  // namespace restenosis

// The lattice in lumens whose outlet is no layer of it.
#include <gtest/gtest.h>

#include "bridge/flow/LumenFrame.h"
#include "bridge/flow/lbm/LbmBackend.h"
#include "tests/support/EllipticDuct.h"
#include "tests/support/FlowSupport.h"
#include "tests/support/HookTube.h"
#include "tests/support/TemporaryFolder.h"

namespace restenosis {
namespace {

using namespace support;

constexpr double tubeRadius = 0.5e-3;

/// Flow so slow that it is developed within a radius behind a bend.
FlowConditions creeping() { return slowConditions(std::numbers::pi * tubeRadius * tubeRadius); }
double creepingStress() { return 4.0 * creeping().dynamicViscosity() * 1e-3 / tubeRadius; }

FlowSolution solvedByLattice(const TriSurface& lumen, const FlowConditions& conditions) {
  LbmSettings settings;
  settings.dx = tubeRadius / 12;
  return AnyDirection(std::make_unique<LbmBackend>(settings)).solve(lumen, conditions, {});
}

/// A tube along z whose outlet is cut by a plane that is inclined by an angle.
TriSurface obliquelyCut(double length, double degrees) {
  TriSurface s =
      sweptTube({{Vec3::Zero(), Vec3::UnitZ()}, {length * Vec3::UnitZ(), Vec3::UnitZ()}}, tubeRadius);
  for (Vec3& v : s.vertices)
    if (v.z() > 0.5 * length) v.z() += v.x() * std::tan(degrees * std::numbers::pi / 180.0);
  return s;
}

class ObliqueOutlet : public ::testing::TestWithParam<double> {};

TEST_P(ObliqueOutlet, leavesPoiseuillesFlowAsItIs) {
  constexpr double length = 2.5e-3;
  const auto s = solvedByLattice(obliquelyCut(length, GetParam()), creeping());
  // One pressure on an oblique plane is not that of Poiseuille's flow, which differs along the plane
  const double clear = length - (1.0 + std::tan(GetParam() * std::numbers::pi / 180.0)) * tubeRadius;
  const auto error = stressError(s, creepingStress(), 0.1e-3, clear);
  RecordProperty("mean", std::to_string(error.mean));
  RecordProperty("l2", std::to_string(error.l2));
  EXPECT_LT(std::abs(error.mean), 0.01);
  EXPECT_LT(error.l2, 0.02);
  EXPECT_LT(s.massImbalance, 0.005);
  EXPECT_TRUE(s.remarks.empty());
}

INSTANTIATE_TEST_SUITE_P(angles, ObliqueOutlet, ::testing::Values(2.0, 30.0, 50.0));

/// The flow leaves against the direction in which it enters, in the plane of the inlet and beyond it.
TEST(BentLattice, aHooksLimbsFeelPoiseuillesStress) {
  for (const double after : {1.0e-3, 1.3e-3}) {
    constexpr double before = 1.0e-3, bend = 0.9e-3;
    auto s = solvedByLattice(hookTube(tubeRadius, before, bend, after), creeping());
    EXPECT_LT(s.massImbalance, 0.01);
    for (WallFace& f : s.wall)  // the limbs one behind the other
      if (f.centre.x() > bend) f.centre.z() = 10e-3 - f.centre.z();
    const auto first = stressError(s, creepingStress(), 0.1e-3, before - tubeRadius);
    const double end = 10e-3 - (before - after);
    const auto last = stressError(s, creepingStress(), 10e-3 - (before - tubeRadius), end - 0.1e-3);
    EXPECT_LT(std::abs(first.mean), 0.015) << after;
    EXPECT_LT(std::abs(last.mean), 0.015) << after;
    EXPECT_LT(first.l2, 0.03) << after;
    EXPECT_LT(last.l2, 0.03) << after;
  }
}

/// A tube that bends by 60 degrees, in a plane through z that is turned about it.
TriSurface turnedBend(double turnedDegrees) {
  constexpr double bend = 1e-3, arc = std::numbers::pi / 3, straight = 0.6e-3;
  constexpr int pieces = 24;
  std::vector<AxisPoint> axis{{Vec3(0, 0, -straight), Vec3::UnitZ()}};
  for (int i = 0; i <= pieces; ++i) {
    const double turn = arc * i / pieces;
    axis.push_back(
        {bend * Vec3(1 - std::cos(turn), 0, std::sin(turn)), Vec3(std::sin(turn), 0, std::cos(turn))});
  }
  axis.push_back({axis.back().place + straight * axis.back().direction, axis.back().direction});
  TriSurface s = sweptTube(axis, tubeRadius);
  const Eigen::AngleAxisd turned(turnedDegrees * std::numbers::pi / 180.0, Vec3::UnitZ());
  for (Vec3& v : s.vertices) v = turned * v;
  return s;
}

/// However the outlet cuts the lattice, some nodes in its rim have few neighbours: with inertia they must not
/// run away, which shorter steps would not help.
TEST(BentLattice, inertiaLeavesThroughAnOutletThatCutsTheLatticeAnyhow) {
  FlowConditions conditions = vesselConditions();
  conditions.flowRate = 0.2 * std::numbers::pi * tubeRadius * tubeRadius;
  for (const double turned : {0.0, 29.0, 58.0}) {
    const TemporaryFolder folder;
    LbmSettings settings;
    settings.dx = tubeRadius / 8;
    settings.coarseLevels = 0;
    settings.tolerance = 0.1;
    AnyDirection(std::make_unique<LbmBackend>(settings)).solve(turnedBend(turned), conditions, folder.path());
    const std::string log = readText(folder / "log.lbm");
    EXPECT_EQ(log.find("diverged"), std::string::npos) << turned << '\n' << log;
  }
}

/// The pressure that drives the flow is lost along the lumen's axis.
TEST(BentLattice, aPressureGradientDrivesPoiseuillesFlow) {
  constexpr double before = 1.5e-3, bend = 2e-3, after = 1.5e-3;
  FlowConditions conditions = creeping();
  conditions.drive = FlowConditions::Drive::pressureGradient;
  conditions.pressureGradient = 8.0 * conditions.dynamicViscosity() * 1e-3 / (tubeRadius * tubeRadius);
  auto s = solvedByLattice(bentTube(tubeRadius, before, bend, after), conditions);
  const auto error = stressError(s, creepingStress(), 0.2e-3, before - tubeRadius);
  EXPECT_LT(std::abs(error.mean), 0.03);
  EXPECT_NEAR(
      s.pressureDrop / (conditions.pressureGradient * (before + after + 0.5 * std::numbers::pi * bend)), 1.0,
      0.02);
}

}  // namespace
}  // namespace restenosis

// Lumens from files, as a user brings them: no axis along z, no names, ends to be found.
#include <gtest/gtest.h>

#include "bridge/flow/LumenFrame.h"
#include "bridge/flow/foam/FoamBackend.h"
#include "bridge/surface/LoadedLumen.h"
#include "bridge/surface/StlFile.h"
#include "tests/support/FlowSupport.h"
#include "tests/support/HookTube.h"
#include "tests/support/OpenFoamPresent.h"
#include "tests/support/SweptTube.h"
#include "tests/support/TemporaryFolder.h"
#include "tests/support/TubeSurface.h"
#include "tests/support/VesselFlowChecks.h"

namespace restenosis {
namespace {

using namespace support;

AnyDirection draft() {
  return AnyDirection(std::make_unique<FoamBackend>(FoamSettings::forFidelity("draft")));
}

/// The error of the stress where the place along the tube, as `along` gives it for a place in space, lies
/// between two limits. The traction must point along the axis there.
template <class Along>
StressError errorAlong(FlowSolution solution, const Along& along, double from, double to) {
  for (WallFace& f : solution.wall) f.centre.z() = along(f.centre);
  return stressError(solution, vesselStress(), from, to);
}

TEST(AnyLumen, anObliqueTubeFeelsPoiseuillesStress) {
  RESTENOSIS_NEEDS_OPENFOAM();
  const TemporaryFolder scratch;
  const auto motion = motionTo(Vec3(1, 2, 3), Vec3(2e-3, 1e-3, -3e-3));
  writeStl(scratch / "oblique.stl", moved(tube(vesselRadius, vesselLength), motion), 1e-6);
  auto backend = draft();
  const auto s =
      backend.solve(loadLumen(scratch / "oblique.stl", 1e-6), vesselConditions(), scratch / "case");
  const auto back = motion.inverse();
  const auto error = errorAlong(
      s, [&](const Vec3& p) { return (back * p).z(); }, endMargin, vesselLength - endMargin);
  RecordProperty("mean", std::to_string(error.mean));
  RecordProperty("l2", std::to_string(error.l2));
  EXPECT_LT(std::abs(error.mean), meanLimit);
  EXPECT_LT(error.l2, l2Limit);
  const Vec3 axis = motion.linear() * Vec3::UnitZ();
  for (const WallFace& f : s.wall) ASSERT_GT(f.traction.dot(axis), 0.0);
  EXPECT_TRUE(s.remarks.empty());
}

/// Wall area over that of a tube of this length, and outflow that is inflow: the mesh is the lumen's.
void expectWhole(const FlowSolution& s, double radius, double length) {
  double area = 0.0;
  for (const WallFace& f : s.wall) area += f.area;
  EXPECT_NEAR(area / (2.0 * std::numbers::pi * radius * length), 1.0, 0.02);
  EXPECT_LT(s.massImbalance, 1e-3);
  for (const auto& remark : s.remarks) ADD_FAILURE() << remark;
}

/// Narrow, so that few cells fill it; the accuracy is tested in tests/long.
constexpr double narrow = 0.5e-3;

TEST(AnyLumen, aBentTubeIsMeshedFromItsInletOn) {
  RESTENOSIS_NEEDS_OPENFOAM();
  const TemporaryFolder scratch;
  writeStl(scratch / "bent.stl",
           moved(bentTube(narrow, 0.6e-3, 1e-3, 0.4e-3), motionTo(Vec3(1, 2, 3), Vec3(0, 0, 0))), 1e-3);
  auto backend = draft();
  const auto s = backend.solve(loadLumen(scratch / "bent.stl", 1e-3), vesselConditions(), scratch / "case");
  expectWhole(s, narrow, 1e-3 + 0.5 * std::numbers::pi * 1e-3);
}

/// The outlet lies beyond the plane of the inlet, so that no plane can cut the lumen there.
TEST(AnyLumen, anArchIsMeshedWithBothCaps) {
  RESTENOSIS_NEEDS_OPENFOAM();
  const TemporaryFolder scratch;
  writeStl(scratch / "arch.stl", hookTube(narrow, 0.0, 0.9e-3, 0.4e-3), 1e-3);
  auto backend = draft();
  const auto s = backend.solve(loadLumen(scratch / "arch.stl", 1e-3), vesselConditions(), scratch / "case");
  expectWhole(s, narrow, 0.4e-3 + std::numbers::pi * 0.9e-3);
}

/// A plane through the inlet would cut the outlet off as well: both are caps, in the file's place or turned.
/// The stress in the arc is that of the same one with a limb that ends 0.2 mm short of the other.
TEST(AnyLumen, endsInOnePlaneAreToldApart) {
  RESTENOSIS_NEEDS_OPENFOAM();
  const TemporaryFolder scratch;
  constexpr double before = 0.5e-3, bend = 0.9e-3;
  const auto stressOf = [&](const TriSurface& lumen, const Eigen::Isometry3d& motion) {
    writeStl(scratch / "hook.stl", moved(lumen, motion), 1e-3);
    auto backend = draft();
    auto s = backend.solve(loadLumen(scratch / "hook.stl", 1e-3), vesselConditions(), scratch / "case");
    const auto back = motion.inverse();
    std::erase_if(s.wall, [&](const WallFace& f) { return (back * f.centre).z() < before; });
    return meanStress(s);
  };
  const auto inPlace = motionTo(Vec3::UnitZ(), Vec3::Zero());
  const double apart = stressOf(hookTube(narrow, before, bend, before - 0.2e-3), inPlace);
  for (const auto& [difference, motion] :
       {std::pair{1e-9, inPlace}, {0.0, motionTo(Vec3(1, 2, 3), Vec3(1e-3, 2e-3, -3e-3))}})
    EXPECT_NEAR(stressOf(hookTube(narrow, before, bend, before + difference), motion) / apart, 1.0, 0.02);
}

/// Of each eight lengths one put the point inside the lumen into a cell whose centre is outside.
TEST(AnyLumen, hooksOfAnyLengthAreMeshed) {
  RESTENOSIS_NEEDS_OPENFOAM();
  const TemporaryFolder scratch;
  for (const double before : {0.4e-3, 0.415e-3, 0.43e-3}) {
    auto backend = draft();
    const auto s =
        backend.solve(hookTube(narrow, before, 1e-3, 0.3e-3), vesselConditions(), scratch / "case");
    expectWhole(s, narrow, before + 0.3e-3 + std::numbers::pi * 1e-3);
  }
}

}  // namespace
}  // namespace restenosis

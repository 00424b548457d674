// A bent tube from a file, at the accuracy of a tube along z where it is straight.
#include <gtest/gtest.h>

#include <numbers>

#include "bridge/flow/LumenFrame.h"
#include "bridge/flow/foam/FoamBackend.h"
#include "bridge/surface/LoadedLumen.h"
#include "bridge/surface/StlFile.h"
#include "tests/support/Constants.h"
#include "tests/support/FlowSupport.h"
#include "tests/support/OpenFoamPresent.h"
#include "tests/support/SweptTube.h"
#include "tests/support/TemporaryFolder.h"

namespace restenosis {
namespace {

using namespace support;

/// The inlet straight is upstream of the bend, but what a bend does decays as exp(-1.84 z / R) against the
/// flow as well. Measured by slices of 0.1 mm: L2 of 1.8 % at one diameter before the bend, 7.7 % at half of
/// one; the mean around keeps within 0.6 % all the way. Behind the bend the profile would need many
/// diameters.
TEST(BentTube, feelsPoiseuillesStressWhereItIsStraight) {
  RESTENOSIS_NEEDS_OPENFOAM();
  const TemporaryFolder scratch;
  constexpr double before = 2.8e-3, bend = 2.7e-3, endMargin = 0.1e-3;
  const auto motion = motionTo(Vec3(1, 2, 3), Vec3(2e-3, 1e-3, -3e-3));
  const SurfaceRegion open[] = {SurfaceRegion::wall};
  writeStl(scratch / "bent.stl", moved(bentTube(vesselRadius, before, bend, 0.6e-3), motion), 1e-3, open);
  AnyDirection backend(std::make_unique<FoamBackend>(FoamSettings::forFidelity("draft")));
  auto s = backend.solve(loadLumen(scratch / "bent.stl", 1e-3), vesselConditions(), scratch / "case");
  for (const auto& remark : s.remarks) ADD_FAILURE() << remark;
  const auto back = motion.inverse();
  for (WallFace& f : s.wall) f.centre = back * f.centre;

  const auto oneDiameter = stressError(s, vesselStress(), endMargin, before - 2 * vesselRadius);
  RecordProperty("mean", std::to_string(oneDiameter.mean));
  RecordProperty("l2", std::to_string(oneDiameter.l2));
  EXPECT_LT(std::abs(oneDiameter.mean), 0.02);
  EXPECT_LT(oneDiameter.l2, 0.025);
  EXPECT_LT(std::abs(stressError(s, vesselStress(), endMargin, before - vesselRadius).mean), 0.02);

  // Into the bend flow is fastest inside, as without friction; further on the fast core is carried to the
  // outer wall.
  const auto outerOverInner = [&](double from, double to) {
    double inner = 0.0, outer = 0.0, innerArea = 0.0, outerArea = 0.0;
    for (const WallFace& f : s.wall) {
      const Vec3 p = f.centre - Vec3(bend, 0, before);  // from the centre of the arc
      const double angle = std::atan2(p.z(), -p.x()), distance = std::hypot(p.x(), p.z());
      if (angle < from || angle > to) continue;
      if (distance < bend - 0.7 * vesselRadius) inner += f.area * f.traction.norm(), innerArea += f.area;
      if (distance > bend + 0.7 * vesselRadius) outer += f.area * f.traction.norm(), outerArea += f.area;
    }
    return outer / outerArea * innerArea / inner;
  };
  constexpr double degree = std::numbers::pi / 180;
  RecordProperty("outerOverInner", std::to_string(outerOverInner(60 * degree, 90 * degree)));
  EXPECT_LT(outerOverInner(0, 30 * degree), 0.7);
  EXPECT_GT(outerOverInner(60 * degree, 90 * degree), 1.4);
}

}  // namespace
}  // namespace restenosis

#include <gtest/gtest.h>

#include <cmath>

#include "bridge/flow/WomersleyFlow.h"
#include "bridge/flow/foam/FoamBackend.h"
#include "bridge/flow/foam/FoamBeats.h"
#include "bridge/flow/foam/FoamVelocity.h"
#include "tests/support/FlowSupport.h"
#include "tests/support/OpenFoamPresent.h"
#include "tests/support/TemporaryFolder.h"
#include "tests/support/TubeSurface.h"
#include "tests/support/VesselFlowChecks.h"

namespace restenosis {
namespace {

using namespace support;

/// Womersley number 2.5 to 3.5, flow that turns near the wall, and a beat that ends at the phase [beats].
Waveform strongBeat(double phase) {
  Waveform waveform{.period = 0.9};
  waveform.harmonics[0] = 1.6 * std::polar(1.0, 2 * std::numbers::pi * phase);
  waveform.harmonics[1] = 0.5 * std::polar(1.0, 2 * std::numbers::pi * (2 * phase + 0.1));
  return waveform;
}

/// The stress on the wall over a beat, by the closed form [Pa].
BeatStress exactStress(const WomersleyFlow& flow, double period) {
  constexpr int times = 1000;
  std::vector<Vec3> tractions;
  for (int n = 0; n < times; ++n)
    tractions.push_back({0, 0, vesselStress() * flow.wallStress(period * n / times)});
  return beatStress(tractions, Vec3::UnitX());
}

/// Relative L2 norm of the velocity's error half way along, at the end of the last beat, where a shift of
/// phase by a hundredth of a beat is an error of 3 to 7 %.
double velocityError(const std::filesystem::path& folder, const WomersleyFlow& flow, double end) {
  std::vector<Vec3> places;
  std::vector<double> shares;
  for (int n = 0; n < 20; ++n) {
    shares.push_back((n + 0.5) / 20);
    places.push_back({0, shares.back() * vesselRadius, vesselLength / 2});
  }
  const auto velocities = foamVelocities(folder / beatsFolder, places);
  const double mean = vesselConditions().flowRate / (std::numbers::pi * vesselRadius * vesselRadius);
  double square = 0, whole = 0;
  for (std::size_t n = 0; n < places.size(); ++n) {
    const double exact = mean * flow.velocity(shares[n], end);
    square += shares[n] * std::pow(velocities[n].z() - exact, 2);
    whole += shares[n] * exact * exact;
  }
  return std::sqrt(square / whole);
}

TEST(BeatingTube, HasWomersleysVelocityAndStress) {
  RESTENOSIS_NEEDS_OPENFOAM();
  for (const double phase : {0.0, 0.3}) {
    SCOPED_TRACE(phase);
    const TemporaryFolder scratch;
    FlowConditions conditions = vesselConditions();
    conditions.beating = Beating{.waveform = strongBeat(phase), .beats = 2};
    FoamBackend backend(FoamSettings::forFidelity("draft"));
    const auto s = backend.solve(tube(vesselRadius, vesselLength), conditions, scratch.path() / "case");
    const double period = conditions.beating->waveform.period;
    const WomersleyFlow flow(conditions.beating->waveform, vesselRadius, conditions.kinematicViscosity);
    EXPECT_LT(velocityError(scratch.path() / "case", flow, 2 * period), 0.02);
    const BeatStress exact = exactStress(flow, period);
    double area = 0, average = 0, index = 0;
    for (const WallFace& face : s.wall) {
      if (face.centre.z() < endMargin || face.centre.z() > vesselLength - endMargin) continue;
      area += face.area;
      average += face.area * face.beat.average;
      index += face.area * face.beat.oscillatoryIndex();
      ASSERT_NEAR(face.traction.norm(), face.beat.average, 1e-12);
    }
    EXPECT_NEAR(average / area / exact.average, 1, 0.02);
    EXPECT_GT(exact.oscillatoryIndex(), 0.05);
    EXPECT_NEAR(index / area, exact.oscillatoryIndex(), 0.01);
    EXPECT_EQ(s.beats.beats, 2);
    EXPECT_LT(s.beats.change, 0.05);  // the first beat begins with steady flow
  }
}

}  // namespace
}  // namespace restenosis

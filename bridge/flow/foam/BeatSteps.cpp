#include "bridge/flow/foam/BeatSteps.h"

#include <algorithm>

namespace restenosis {
namespace {

/// Samples of a beat at most (assumed: a series of eight harmonics has 17 numbers).
constexpr int mostSamples = 50;

/// How often b fits into a, rounded up.
int roundedUp(int a, int b) { return (a + b - 1) / b; }

}  // namespace

BeatSteps::BeatSteps(double period, int beats, const FoamSettings& settings) {
  const auto wanted = static_cast<int>(settings.beatSteps);
  sampleSteps = roundedUp(wanted, mostSamples);
  samples = roundedUp(wanted, sampleSteps);
  step = period / (samples * sampleSteps);
  end = beats * period;
  // The sample that falls on the beginning belongs to the beat before, and OpenFOAM takes half a step more
  sampleFrom = (beats - 2) * period + step;
}

}  // namespace restenosis

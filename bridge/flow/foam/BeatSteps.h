#pragma once

#include "bridge/flow/foam/FoamSettings.h"

namespace restenosis {

/// The time steps of a case of beats, and when the wall's stress is sampled.
struct BeatSteps {
  /// `period` in s. Steps are rounded up so that samples are evenly spaced.
  BeatSteps(double period, int beats, const FoamSettings& settings);

  double end = 0.0;   ///< of the last beat [s]
  double step = 0.0;  ///< [s]
  int sampleSteps = 1;
  int samples = 0;          ///< of a beat
  double sampleFrom = 0.0;  ///< [s], the first step of the last beat but one
};

}  // namespace restenosis

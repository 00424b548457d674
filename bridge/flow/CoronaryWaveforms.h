#pragma once

#include <string_view>
#include <vector>

#include "bridge/flow/Waveform.h"

namespace restenosis {

/// Names of the waveforms below.
std::vector<std::string_view> coronaryWaveformNames();

/// A waveform of a coronary artery, from the start of systole on, its mean 1. Throws std::invalid_argument
/// for another name.
///   coronaryLeft   measured: the mean of 32 pigs, 76 beats a minute (public data of
///                  github.com/vsturgess/SVD-CoronaryWaveforms; the vessel, by its shape a left one, is not
///                  named)
///   coronaryRight  a model: the lumped network of Kim et al. 2010 with the numbers of Raza 2024 and half the
///                  pressure of the left ventricle around the small vessels
std::vector<WaveformPoint> coronaryWaveform(std::string_view name);

}  // namespace restenosis

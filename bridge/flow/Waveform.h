#pragma once

#include <array>
#include <complex>
#include <filesystem>
#include <span>
#include <vector>

#include "tissue/parameters/CsvLines.h"

namespace restenosis {

/// The flow rate of a beating heart over its mean, as Fourier series
///   q(t) = 1 + Re sum over n of a_n exp(2 pi i n t / period), n from 1.
struct Waveform {
  static constexpr std::size_t order = 8;
  double period = 0.0;                                  ///< [s]
  std::array<std::complex<double>, order> harmonics{};  ///< a_1 first

  /// 2 pi n / period [1/s].
  double angularFrequency(std::size_t n) const;
  /// q(t); t in s.
  double operator()(double t) const;
};

/// Flow rate, in any unit, at a time [s].
struct WaveformPoint {
  double time, flowRate;
};

/// The series of a curve that is straight from point to point, t = 0 at the first. Times must increase; the
/// last point is the first one of the next beat. The mean must be positive.
Waveform waveformThrough(std::span<const WaveformPoint> points);

/// How far the series is from the curve: root mean square over the mean flow rate.
double seriesError(const Waveform& waveform, std::span<const WaveformPoint> points);

/// Reads a table: the line `time,flowRate`, then at least four lines of a time [s] and a flow rate in any
/// unit, one beat from its first time to its last, where the flow rate is again what it was. Lines may be
/// empty or comments that begin with #. Throws TableError.
std::vector<WaveformPoint> readWaveform(const std::filesystem::path& file);

}  // namespace restenosis

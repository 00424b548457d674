#include "bridge/flow/Waveform.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

#include "tissue/parameters/Shown.h"

namespace restenosis {
namespace {

constexpr std::size_t fewestPoints = 4;
/// How far the last flow rate may be from the first, over the largest (assumed: what rounding leaves).
constexpr double closesWithin = 0.01;

/// The mean of the curve times exp(-i k t).
std::complex<double> meanWith(std::span<const WaveformPoint> points, double k) {
  using namespace std::complex_literals;
  const double period = points.back().time - points.front().time;
  std::complex<double> sum = 0;
  for (std::size_t n = 0; n + 1 < points.size(); ++n) {
    const auto [from, low] = points[n];
    const auto [to, high] = points[n + 1];
    if (k == 0) {
      sum += 0.5 * (to - from) * (low + high);
      continue;
    }
    // By parts: the curve's jumps cancel from point to point, its slope stays
    const auto atEnd = [&](double t, double value) { return value * std::exp(-1i * k * t) / (-1i * k); };
    const double slope = (high - low) / (to - from);
    sum += atEnd(to, high) - atEnd(from, low) +
           slope / (k * k) * (std::exp(-1i * k * to) - std::exp(-1i * k * from));
  }
  return sum / period;
}

}  // namespace

double Waveform::angularFrequency(std::size_t n) const {
  return 2 * std::numbers::pi * static_cast<double>(n) / period;
}

double Waveform::operator()(double t) const {
  double value = 1;
  for (std::size_t n = 1; n <= order; ++n)
    value += (harmonics[n - 1] * std::polar(1.0, angularFrequency(n) * t)).real();
  return value;
}

Waveform waveformThrough(std::span<const WaveformPoint> points) {
  Waveform waveform{.period = points.back().time - points.front().time};
  const double mean = meanWith(points, 0).real(), start = points.front().time;
  for (std::size_t n = 1; n <= Waveform::order; ++n) {
    const double k = waveform.angularFrequency(n);
    waveform.harmonics[n - 1] = 2.0 * meanWith(points, k) / mean * std::polar(1.0, k * start);
  }
  return waveform;
}

double seriesError(const Waveform& waveform, std::span<const WaveformPoint> points) {
  // By Parseval's theorem: what the harmonics do not hold of the curve's own square
  const double mean = meanWith(points, 0).real();
  double square = 0;
  for (std::size_t n = 0; n + 1 < points.size(); ++n) {
    const double a = points[n].flowRate / mean - 1, b = points[n + 1].flowRate / mean - 1;
    square += (points[n + 1].time - points[n].time) / waveform.period * (a * a + a * b + b * b) / 3;
  }
  for (const auto& a : waveform.harmonics) square -= 0.5 * std::norm(a);
  return std::sqrt(std::max(0.0, square));
}

std::vector<WaveformPoint> readWaveform(const std::filesystem::path& file) {
  using Cells = std::vector<std::string_view>;
  CsvLines lines(file);
  std::vector<WaveformPoint> points;
  if (lines.next() && lines.cells() != Cells{"time", "flowRate"})
    lines.fail(fmt::format("{} is no header of a waveform; it must be 'time,flowRate'", shown(lines.text())));
  while (lines.next()) {
    const Cells cells = lines.cells();
    const auto time = finiteNumber(cells.front()), flowRate = finiteNumber(cells.back());
    if (cells.size() != 2 || !time || !flowRate)
      lines.fail(fmt::format("{} is not a time in seconds and a flow rate, two numbers with a comma between",
                             shown(lines.text())));
    if (!points.empty() && !(*time > points.back().time))
      lines.fail(fmt::format("the time {:g} s does not come after {:g} s", *time, points.back().time));
    points.push_back({*time, *flowRate});
  }
  if (points.size() < fewestPoints)
    lines.failWhole(
        fmt::format("holds {} points of a waveform; at least {} are needed", points.size(), fewestPoints));
  const auto size = [](const WaveformPoint& p) { return std::abs(p.flowRate); };
  const double largest = size(*std::ranges::max_element(points, {}, size));
  if (std::abs(points.back().flowRate - points.front().flowRate) > closesWithin * largest)
    lines.fail(fmt::format(
        "the beat ends with the flow rate {:g}, but began with {:g}: its last point must be the first "
        "of the next beat",
        points.back().flowRate, points.front().flowRate));
  if (!(meanWith(points, 0).real() > 0)) lines.failWhole("the mean flow rate is not positive");
  return points;
}

}  // namespace restenosis

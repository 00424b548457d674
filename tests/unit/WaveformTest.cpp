#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bridge/flow/CoronaryWaveforms.h"
#include "tests/support/TemporaryFolder.h"

namespace restenosis {
namespace {

TEST(Waveform, OfASawtoothHasItsSeries) {
  // From 0 to 2 in a period and back at once: 1 - (2 / pi) sum of sin(n w t) / n; it begins at 3 s
  const std::vector<WaveformPoint> sawtooth{{3, 0}, {5 - 1e-9, 2}, {5, 0}};
  const Waveform waveform = waveformThrough(sawtooth);
  EXPECT_DOUBLE_EQ(waveform.period, 2);
  for (std::size_t n = 1; n <= Waveform::order; ++n) {
    // -sin(w t) is the real part of i exp(i w t)
    const std::complex<double> expected(0, 2 / std::numbers::pi / static_cast<double>(n));
    EXPECT_NEAR(std::abs(waveform.harmonics[n - 1] - expected), 0, 1e-6) << n;
  }
  // What is left is the tail: half of the sum of (2 / (pi n))^2 beyond the last harmonic
  double tail = std::numbers::pi * std::numbers::pi / 6;
  for (std::size_t n = 1; n <= Waveform::order; ++n) tail -= 1.0 / static_cast<double>(n * n);
  EXPECT_NEAR(seriesError(waveform, sawtooth), std::sqrt(2 * tail) / std::numbers::pi, 1e-6);
}

TEST(Waveform, GoesThroughSmoothCurves) {
  std::vector<WaveformPoint> points;
  const auto curve = [](double t) {
    return 5 * (1 + 0.5 * std::cos(2 * std::numbers::pi * 3 * (t - 0.1) / 0.8));
  };
  for (int n = 0; n <= 800; ++n) points.push_back({n * 1e-3, curve(n * 1e-3)});
  const Waveform waveform = waveformThrough(points);
  for (const double t : {0.0, 0.13, 0.5, 0.9}) EXPECT_NEAR(waveform(t), curve(t) / 5, 2e-4) << t;
  EXPECT_LT(seriesError(waveform, points), 1e-3);
}

TEST(Waveform, OfCoronaryArteriesIsOneInTheMean) {
  for (const std::string_view name : coronaryWaveformNames()) {
    SCOPED_TRACE(name);
    const auto points = coronaryWaveform(name);
    double mean = 0;
    for (std::size_t n = 0; n + 1 < points.size(); ++n)
      mean += 0.5 * (points[n].flowRate + points[n + 1].flowRate) * (points[n + 1].time - points[n].time);
    const Waveform waveform = waveformThrough(points);
    EXPECT_NEAR(mean / waveform.period, 1, 1e-3);
    EXPECT_EQ(points.front().flowRate, points.back().flowRate);
    EXPECT_LT(seriesError(waveform, points), 0.05);
  }
  EXPECT_THROW(coronaryWaveform("aorta"), std::invalid_argument);
}

TEST(Waveform, IsReadFromATable) {
  const TemporaryFolder folder;
  writeText(folder / "beat.csv", "# measured\n\ntime,flowRate\n0, 1\n0.25, 3 # peak\r\n0.5,1\n0.8,1\n");
  const auto points = readWaveform(folder / "beat.csv");
  ASSERT_EQ(points.size(), 4u);
  EXPECT_EQ(points[1].time, 0.25);
  EXPECT_EQ(points[1].flowRate, 3);
}

TEST(Waveform, OfATableThatIsNoneIsRefusedWithItsLine) {
  const TemporaryFolder folder;
  const auto file = folder / "beat.csv";
  const auto said = [&](const std::string& text) -> std::string {
    writeText(file, text);
    try {
      readWaveform(file);
      return "accepted";
    } catch (const TableError& error) {
      return std::string(error.what()).substr(file.string().size());
    }
  };
  EXPECT_EQ(said("time,flowRate\n0,1\n1,2\n2,2\n3,1\n"), "accepted");
  EXPECT_TRUE(said("t,q\n0,1\n").starts_with(":1: 't,q' is no header"));
  EXPECT_TRUE(said("time,flowRate\n0;1\n").starts_with(":2: '0;1' is not a time"));
  EXPECT_TRUE(said("time,flowRate\n0,1\n1,nan\n").starts_with(":3: '1,nan' is not"));
  EXPECT_TRUE(
      said("time,flowRate\n0,1\n1,2\n1,2\n3,1\n").starts_with(":4: the time 1 s does not come after 1 s"));
  EXPECT_TRUE(said("time,flowRate\n0,1\n1,2\n2,1\n").starts_with(": holds 3 points"));
  EXPECT_TRUE(
      said("time,flowRate\n0,1\n1,2\n2,2\n3,2\n").starts_with(":5: the beat ends with the flow rate 2"));
  EXPECT_TRUE(
      said("time,flowRate\n0,1\n1,-2\n2,-2\n3,1\n").starts_with(": the mean flow rate is not positive"));
  std::filesystem::remove(file);
  EXPECT_THROW(readWaveform(file), TableError);
}

}  // namespace
}  // namespace restenosis

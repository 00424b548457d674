#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "bridge/flow/WomersleyFlow.h"
#include "bridge/flow/foam/PowersOfW.h"

namespace restenosis {
namespace {

/// Two harmonics, 0.9 s.
Waveform twoHarmonics() {
  Waveform waveform{.period = 0.9};
  waveform.harmonics[0] = 0.8, waveform.harmonics[4] = {0.1, 0.3};
  return waveform;
}

TEST(WomersleyFlow, HasTheClosedFormsValues) {
  // By another library's Bessel functions: radius [m], velocity at four distances from the axis, wall stress
  struct Values {
    double radius;
    std::array<double, 4> velocity;
    double stress;
  };
  constexpr std::array table{
      Values{1e-4, {3.24179494189, 2.95031594567, 0.616471782581, 0.0645789752468}, 1.62262161021},
      Values{0.9e-3, {3.16499164076, 2.89771723402, 0.63927158663, 0.0678904313572}, 1.70856524115},
      Values{8e-3, {2.73841883429, 2.55567820287, 0.799701196758, 0.116568005764}, 3.13538340314},
      Values{0.4, {2.62365136033, 2.44365136033, 1.00365136033, 0.669909676464}, 95.0113242478}};
  constexpr std::array shares{0.0, 0.3, 0.9, 0.99};
  for (const Values& values : table) {
    SCOPED_TRACE(values.radius);
    const WomersleyFlow flow(twoHarmonics(), values.radius, 2.7e-6);
    for (std::size_t k = 0; k < shares.size(); ++k)
      EXPECT_NEAR(flow.velocity(shares[k], 0.1), values.velocity[k], 1e-10);
    EXPECT_NEAR(flow.wallStress(0.1) / values.stress, 1, 1e-10);
  }
}

TEST(WomersleyFlow, CarriesTheFlowRateOfItsWaveform) {
  const WomersleyFlow flow(twoHarmonics(), 2e-3, 2.7e-6);
  for (const double t : {0.0, 0.2, 0.7}) {
    constexpr int rings = 20000;
    double mean = 0;
    for (int n = 0; n < rings; ++n) mean += flow.velocity(std::sqrt((n + 0.5) / rings), t) / rings;
    EXPECT_NEAR(mean, twoHarmonics()(t), 1e-6) << t;
  }
}

TEST(WomersleyFlow, ThatIsSlowIsPoiseuilles) {
  const Waveform waveform = twoHarmonics();
  for (const double radius : {1e-9, 1e-6, 2e-6}) {
    const WomersleyFlow flow(waveform, radius, 2.7e-6);
    EXPECT_NEAR(flow.velocity(0.5, 0.3), 1.5 * waveform(0.3), 1e-5);
    EXPECT_NEAR(flow.wallStress(0.3), waveform(0.3), 1e-5);
  }
}

TEST(PowersOfW, HoldWomersleysProfileInACoronaryArtery) {
  const WomersleyFlow flow(twoHarmonics(), 0.9e-3, 2.7e-6);
  EXPECT_LT(PowersOfW([&](double share) { return flow.harmonic(5, share).real(); }).error(), 1e-10);
  // Where it is steep at the wall, the error says so
  const WomersleyFlow wide(twoHarmonics(), 0.02, 2.7e-6);
  EXPECT_GT(PowersOfW([&](double share) { return wide.harmonic(5, share).real(); }).error(), 0.005);
}

TEST(PowersOfW, AreAProductThatBeginsWithW) {
  const std::string text = PowersOfW([](double share) { return 3 * (1 - share * share); }).expression();
  EXPECT_TRUE(text.starts_with("w*(3+w*(")) << text;
}

}  // namespace
}  // namespace restenosis

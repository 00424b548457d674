#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "bridge/flow/BeatStress.h"
#include "bridge/flow/foam/BeatSteps.h"
#include "bridge/flow/foam/WallSamples.h"
#include "tests/support/TemporaryFolder.h"

namespace restenosis {
namespace {

/// Tractions at evenly spaced phases of a beat, on a face whose normal is y.
template <class Traction>
BeatStress overABeat(Traction&& traction) {
  constexpr int times = 400;
  std::vector<Vec3> tractions;
  for (int n = 0; n < times; ++n) tractions.push_back(traction(2 * std::numbers::pi * n / times));
  return beatStress(tractions, Vec3::UnitY());
}

TEST(BeatStress, OfAFlowThatNeverTurnsDoesNotOscillate) {
  const BeatStress stress = overABeat([](double phase) { return Vec3(0, 0, 2 + std::cos(phase)); });
  EXPECT_NEAR(stress.average, 2, 1e-12);
  EXPECT_NEAR(stress.oscillatoryIndex(), 0, 1e-12);
  EXPECT_NEAR(stress.residenceTime(), 0.5, 1e-12);
  EXPECT_NEAR(stress.transverse, 0, 1e-12);
}

TEST(BeatStress, OfAFlowThatGoesToAndFroHasAnIndexOfAHalf) {
  const BeatStress stress = overABeat([](double phase) { return Vec3(0, 0, std::cos(phase)); });
  EXPECT_NEAR(stress.average, 2 / std::numbers::pi, 1e-4);
  EXPECT_NEAR(stress.oscillatoryIndex(), 0.5, 1e-12);
  EXPECT_GT(stress.residenceTime(), 1e10);
}

TEST(BeatStress, AcrossTheMeanIsTransverse) {
  // Along z in the mean, to and fro along x
  const BeatStress stress = overABeat([](double phase) { return Vec3(3 * std::cos(phase), 0, 4); });
  EXPECT_NEAR((stress.mean - Vec3(0, 0, 4)).norm(), 0, 1e-12);
  EXPECT_NEAR(stress.transverse, 3 * 2 / std::numbers::pi, 1e-3);
  EXPECT_NEAR(stress.oscillatoryIndex(), 0.5 * (1 - 4 / stress.average), 1e-12);
}

TEST(BeatStress, OfAFlowThatTurnsOnceAroundHasNoDirection) {
  const BeatStress stress = overABeat([](double phase) { return Vec3(std::cos(phase), 0, std::sin(phase)); });
  EXPECT_NEAR(stress.average, 1, 1e-12);
  EXPECT_NEAR(stress.oscillatoryIndex(), 0.5, 1e-12);
}

TEST(BeatSteps, SpaceSamplesEvenly) {
  FoamSettings settings;
  for (const int wanted : {20, 50, 60, 75, 200, 1001}) {
    settings.beatSteps = wanted;
    const BeatSteps steps(0.9, 3, settings);
    EXPECT_LE(steps.samples, 50);
    const int taken = steps.samples * steps.sampleSteps;
    EXPECT_GE(taken, wanted);
    EXPECT_LT(taken, wanted + steps.sampleSteps);
    EXPECT_DOUBLE_EQ(steps.step * taken, 0.9);
    EXPECT_DOUBLE_EQ(steps.end, 2.7);
    EXPECT_DOUBLE_EQ(steps.sampleFrom, 0.9 + steps.step);
  }
}

TEST(WallSamples, AreListsOfVectorsInTheOrderOfTime) {
  const TemporaryFolder folder;
  for (const char* time : {"0.9", "1.8", "0.09", "10"}) std::filesystem::create_directory(folder / time);
  writeText(folder / "points", "0()");
  const auto folders = sampleFolders(folder.path());
  ASSERT_EQ(folders.size(), 4u);
  EXPECT_EQ(folders.front().filename(), "0.09");
  EXPECT_EQ(folders.back().filename(), "10");
  writeText(folder / "sample", "\n2\n(\n(1 -2e-3 3)\n(4 5 6)\n)\n");
  const auto sample = readWallSample(folder / "sample");
  ASSERT_EQ(sample.size(), 2u);
  EXPECT_EQ(sample[0], Vec3(1, -2e-3, 3));
  EXPECT_EQ(sample[1], Vec3(4, 5, 6));
}

TEST(WallSamples, ThatAreCutOffOrNotFiniteAreRefused) {
  const TemporaryFolder folder;
  for (const char* text : {"", "2\n(\n(1 2 3)\n(4 5", "1\n(\n(1 nan 3)\n)", "1e30\n(", "-1\n("}) {
    writeText(folder / "sample", text);
    EXPECT_THROW(readWallSample(folder / "sample"), std::runtime_error) << text;
  }
}

}  // namespace
}  // namespace restenosis

#include <gtest/gtest.h>

#include "bridge/coupling/Instant.h"
#include "tissue/parameters/SecondsPerDay.h"

namespace restenosis {
namespace {

TEST(Instant, KnowsDaysRecordsAndTheLastStep) {
  Scene scene;
  scene.scene.duration = 2 * secondsPerDay;
  scene.scene.step = 7 * 3600;
  scene.output.interval = 0.5 * secondsPerDay;
  EXPECT_EQ(stepCount(scene.scene), 7u);
  const auto at = [&](std::uint32_t step) { return instantOf(scene, step); };
  EXPECT_EQ(at(3).time, 21 * 3600);
  EXPECT_TRUE(at(0).recorded);
  EXPECT_FALSE(at(1).recorded);
  EXPECT_TRUE(at(2).recorded) << "14 h are next to 12 h";
  EXPECT_TRUE(at(3).endsDay) << "21 h are next to a day";
  EXPECT_FALSE(at(4).endsDay);
  EXPECT_FALSE(at(6).last);
  EXPECT_TRUE(at(7).last);
  EXPECT_TRUE(at(7).recorded);
}

TEST(Instant, TakesTheLumenAtMultiplesOfItsIntervalAndWhereItIsRecorded) {
  Scene scene;
  scene.scene.duration = 2 * secondsPerDay;
  scene.scene.step = 3600;
  scene.output.interval = 2 * secondsPerDay;
  EXPECT_TRUE(instantOf(scene, 1).takesLumen) << "by default in every step";
  scene.coupling.lumenInterval = 5 * 3600;
  EXPECT_FALSE(instantOf(scene, 1).takesLumen);
  EXPECT_TRUE(instantOf(scene, 5).takesLumen);
  EXPECT_TRUE(instantOf(scene, 24).takesLumen) << "the end of a day";
  EXPECT_TRUE(instantOf(scene, 48).takesLumen) << "recorded";
}

TEST(Instant, OfAMultipleHalfwayBetweenTwoStepsTheFirstIsTaken) {
  EXPECT_TRUE(nextToMultiple(10, 15, 10));
  EXPECT_FALSE(nextToMultiple(20, 15, 10));
  EXPECT_TRUE(nextToMultiple(20, 1, 10)) << "every step holds several";
}

}  // namespace
}  // namespace restenosis

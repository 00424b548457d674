#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "bridge/output/Progress.h"

namespace restenosis {
namespace {

using namespace std::chrono_literals;

struct Clock {
  Progress::Clock::time_point time{};
  std::function<Progress::Clock::time_point()> reader() {
    return [this] { return time; };
  }
};

ProgressState onDay(double day) {
  ProgressState state;
  state.time = 86400 * day;
  state.agents = 68412, state.g0 = 60000, state.g1 = 300, state.sg2m = 112;
  return state;
}

TEST(Progress, ShowsDayAgentsStatesAndTimeLeft) {
  Clock clock;
  std::ostringstream out;
  Progress progress(out, false, 10 * 86400, clock.reader());
  progress.step(onDay(2), true);
  clock.time += 60s;
  progress.step(onDay(4), true);
  const auto text = out.str();
  EXPECT_NE(text.find("day  4.00/10"), std::string::npos) << text;
  EXPECT_NE(text.find("68412 agents  G0 60000  G1 300  S/G2/M 112"), std::string::npos) << text;
  // Two days took a minute, six are left: a run resumed on day 2 must not count the days before.
  EXPECT_NE(text.find("3 min 00 s left"), std::string::npos) << text;
}

TEST(Progress, KnowsNoTimeLeftBeforeTheFirstFlowAndCountsFromIt) {
  Clock clock;
  std::ostringstream out;
  Progress progress(out, false, 10 * 86400, clock.reader());
  ProgressState state = onDay(1);
  state.flowToCome = true;
  progress.step(state, true);
  clock.time += 2s;
  state = onDay(2), state.flowToCome = true;
  progress.step(state, true);
  EXPECT_EQ(out.str().find("left"), std::string::npos) << out.str();
  clock.time += 100s;  // of the flow of day 3
  progress.step(onDay(3), true);
  clock.time += 100s;
  progress.step(onDay(4), true);
  EXPECT_NE(out.str().find("10 min 00 s left, done about "), std::string::npos) << out.str();
}

TEST(Progress, ShowsEveryStepAndWhatTheFlowDoesOnLinesWhereAsked) {
  Clock clock;
  std::ostringstream out;
  Progress progress(out, true, 10 * 86400, clock.reader());
  progress.showEverything();
  for (const double day : {1, 2, 3}) progress.step(onDay(day), false);
  progress.flow("simpleFoam");
  EXPECT_EQ(std::ranges::count(out.str(), '\n'), 4) << out.str();
  EXPECT_EQ(std::ranges::count(out.str(), '\r'), 0) << out.str();
  EXPECT_NE(out.str().find("day  3.00/10  flow: simpleFoam ...\n"), std::string::npos) << out.str();
}

TEST(Progress, SaysWhatTheFlowDoesOnATerminalOnly) {
  for (const bool terminal : {false, true}) {
    std::ostringstream out;
    Progress progress(out, terminal, 10 * 86400);
    progress.step(onDay(3), true);
    progress.flow("snappyHexMesh");
    EXPECT_EQ(out.str().find("day  3.00/10  flow: snappyHexMesh ...") != std::string::npos, terminal);
  }
}

TEST(Progress, WritesPlainLinesSparingly) {
  Clock clock;
  std::ostringstream out;
  Progress progress(out, false, 10 * 86400, clock.reader());
  for (int step = 0; step < 100; ++step, clock.time += 100ms) progress.step(onDay(0.05 * step), false);
  const auto text = out.str();
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 2);
  EXPECT_EQ(text.find('\r'), std::string::npos);
}

TEST(Progress, KeepsOneLineOnATerminal) {
  Clock clock;
  std::ostringstream out;
  Progress progress(out, true, 10 * 86400, clock.reader());
  progress.stage("deployment", 1, 100);
  clock.time += 1s;
  progress.stage("deployment", 2, 100);
  EXPECT_EQ(out.str(), "\rdeployment 1/100\x1b[K\rdeployment 2/100\x1b[K");
  progress.message("flow: meshed again");
  EXPECT_TRUE(out.str().ends_with("\rflow: meshed again\x1b[K\ndeployment 2/100"));
  progress.finish();
  EXPECT_TRUE(out.str().ends_with("deployment 2/100\n"));
}

TEST(Progress, AlwaysShowsTheEnd) {
  Clock clock;
  std::ostringstream out;
  Progress progress(out, false, 10 * 86400, clock.reader());
  progress.step(onDay(9.9), false);
  progress.step(onDay(10), false);
  EXPECT_NE(out.str().find("day 10.00/10"), std::string::npos);
}

}  // namespace
}  // namespace restenosis

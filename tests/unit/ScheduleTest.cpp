#include <gtest/gtest.h>

#include "bridge/coupling/Schedule.h"

namespace restenosis {
namespace {

/// A part whose answers the test sets.
struct FakePart : Part {
  struct Answers {
    Verdict needs = Verdict::run(), changed = Verdict::run();
    int runs = 0;
    bool purpose = false;
  };
  FakePart(std::string n, std::vector<Quantity> r, std::vector<Quantity> w, Answers& a)
      : name_(std::move(n)), reads_(std::move(r)), writes_(std::move(w)), answers_(a) {}
  std::string_view name() const override { return name_; }
  std::vector<Quantity> reads() const override { return reads_; }
  std::vector<Quantity> writes() const override { return writes_; }
  bool isPurpose(const Instant&) const override { return answers_.purpose; }
  Verdict needs(Quantity, const Instant&) const override { return answers_.needs; }
  Verdict inputsChanged(const Instant&) const override { return answers_.changed; }
  void run(const Instant&) override { ++answers_.runs; }

  std::string name_;
  std::vector<Quantity> reads_, writes_;
  Answers& answers_;
};

struct ScheduleTest : testing::Test {
  void build(Schedule::Mode mode) {
    schedule = std::make_unique<Schedule>(mode);
    nitricOxide.purpose = true;
    schedule->add(std::make_unique<FakePart>("surface", std::vector{Quantity::agentPositions},
                                             std::vector{Quantity::lumen}, surface));
    schedule->add(std::make_unique<FakePart>("flow", std::vector{Quantity::lumen},
                                             std::vector{Quantity::wallShearStress}, flow));
    schedule->add(std::make_unique<FakePart>("nitricOxide", std::vector{Quantity::wallShearStress},
                                             std::vector{Quantity::nitricOxide}, nitricOxide));
  }
  FakePart::Answers surface, flow, nitricOxide;
  std::unique_ptr<Schedule> schedule;
};

TEST_F(ScheduleTest, RunsEverythingWhenAllIsNeededAndChanged) {
  build(Schedule::Mode::onChange);
  schedule->advance({});
  EXPECT_EQ(surface.runs, 1);
  EXPECT_EQ(flow.runs, 1);
  EXPECT_EQ(nitricOxide.runs, 1);
}

TEST_F(ScheduleTest, SkipsWhatNobodyDownstreamNeedsAndCountsTheReason) {
  build(Schedule::Mode::onChange);
  nitricOxide.needs = Verdict::skip("no covered cell");
  schedule->advance({});
  schedule->advance({});
  EXPECT_EQ(surface.runs, 0);
  EXPECT_EQ(flow.runs, 0);
  EXPECT_EQ(nitricOxide.runs, 2);  // it is the purpose here
  EXPECT_EQ(schedule->counts().at("flow").skipped.at("no covered cell"), 2u);
  EXPECT_EQ(schedule->counts().at("surface").skipped.at("no covered cell"), 2u);
}

TEST_F(ScheduleTest, SkipsAPartWhoseInputsHaveNotChanged) {
  build(Schedule::Mode::onChange);
  flow.changed = Verdict::skip("lumen moved less than its tolerance");
  schedule->advance({});
  EXPECT_EQ(surface.runs, 1);
  EXPECT_EQ(flow.runs, 0);
  EXPECT_EQ(schedule->counts().at("flow").skippedInAll(), 1u);
}

TEST_F(ScheduleTest, EveryStepAsksNobody) {
  build(Schedule::Mode::everyStep);
  nitricOxide.needs = Verdict::skip("no covered cell");
  flow.changed = Verdict::skip("lumen moved less than its tolerance");
  schedule->advance({});
  EXPECT_EQ(flow.runs, 1);
  EXPECT_TRUE(schedule->counts().at("flow").skipped.empty());
}

TEST_F(ScheduleTest, SkipsWhatNobodyReadsUnlessItIsThePurpose) {
  build(Schedule::Mode::onChange);
  nitricOxide.purpose = false;
  schedule->advance({});
  EXPECT_EQ(flow.runs + nitricOxide.runs, 0);
  EXPECT_EQ(schedule->counts().at("flow").skipped.at("nothing reads what it makes"), 1u);
}

TEST_F(ScheduleTest, AReaderFurtherUpKeepsItsWriterRunning) {
  Schedule loop(Schedule::Mode::onChange);
  FakePart::Answers cycle, relax;
  cycle.purpose = true;
  loop.add(std::make_unique<FakePart>("relax", std::vector{Quantity::cellStates},
                                      std::vector{Quantity::agentPositions}, relax));
  loop.add(std::make_unique<FakePart>("cycle", std::vector{Quantity::agentPositions},
                                      std::vector{Quantity::cellStates}, cycle));
  loop.advance({});
  EXPECT_EQ(relax.runs, 1);
  EXPECT_EQ(cycle.runs, 1);
}

}  // namespace
}  // namespace restenosis

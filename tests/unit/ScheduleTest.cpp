#include <gtest/gtest.h>

#include "bridge/coupling/Schedule.h"
#include "tissue/agents/StateArchive.h"

namespace restenosis {
namespace {

/// What the test lets a part answer.
struct Answers {
  Verdict needs = Verdict::run(), changed = Verdict::run();
  int runs = 0;
  bool purpose = false;
  bool takesLong = false, fails = false;
};

/// A part that makes one quantity of another.
template <Quantity from, Quantity to>
struct FakePart : Part {
  FakePart(Quantities& quantities, std::string n, Answers& a)
      : Part(quantities), name_(std::move(n)), answers_(a) {
    read<from>();
    write<to>();
  }
  std::string_view name() const override { return name_; }
  bool isPurpose(const Instant&) const override { return answers_.purpose; }
  Verdict needs(Quantity, const Instant&) const override { return answers_.needs; }
  Verdict inputsChanged(const Instant&) const override { return answers_.changed; }
  void run(const Instant&) override {
    if (answers_.fails) throw std::runtime_error("killed");
    ++answers_.runs;
  }
  bool takesLong() const override { return answers_.takesLong; }

  std::string name_;
  Answers& answers_;
};

struct ScheduleTest : testing::Test {
  template <Quantity from, Quantity to>
  void add(const char* name, Answers& answers) {
    schedule->add(std::make_unique<FakePart<from, to>>(quantities, name, answers));
  }
  void build(ScheduleMode mode) {
    schedule = std::make_unique<Schedule>(mode);
    nitricOxide.purpose = true;
    add<Quantity::agentPositions, Quantity::lumen>("surface", surface);
    add<Quantity::lumen, Quantity::wallShearStress>("flow", flow);
    add<Quantity::wallShearStress, Quantity::nitricOxide>("nitricOxide", nitricOxide);
  }
  Quantities quantities{Wall()};
  Answers surface, flow, nitricOxide;
  std::unique_ptr<Schedule> schedule;
};

TEST_F(ScheduleTest, RunsEverythingWhenAllIsNeededAndChanged) {
  build(ScheduleMode::onChange);
  schedule->advance({});
  EXPECT_EQ(surface.runs, 1);
  EXPECT_EQ(flow.runs, 1);
  EXPECT_EQ(nitricOxide.runs, 1);
}

TEST_F(ScheduleTest, SkipsWhatNobodyDownstreamNeedsAndCountsTheReason) {
  build(ScheduleMode::onChange);
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
  build(ScheduleMode::onChange);
  flow.changed = Verdict::skip("lumen moved less than its tolerance");
  schedule->advance({});
  EXPECT_EQ(surface.runs, 1);
  EXPECT_EQ(flow.runs, 0);
  EXPECT_EQ(schedule->counts().at("flow").skippedInAll(), 1u);
}

TEST_F(ScheduleTest, EveryStepAsksNobody) {
  build(ScheduleMode::everyStep);
  nitricOxide.needs = Verdict::skip("no covered cell");
  flow.changed = Verdict::skip("lumen moved less than its tolerance");
  schedule->advance({});
  EXPECT_EQ(flow.runs, 1);
  EXPECT_TRUE(schedule->counts().at("flow").skipped.empty());
}

TEST_F(ScheduleTest, SkipsWhatNobodyReadsUnlessItIsThePurpose) {
  build(ScheduleMode::onChange);
  nitricOxide.purpose = false;
  schedule->advance({});
  EXPECT_EQ(flow.runs + nitricOxide.runs, 0);
  EXPECT_EQ(schedule->counts().at("flow").skipped.at("nothing reads what it makes"), 1u);
}

TEST_F(ScheduleTest, AReaderFurtherUpKeepsItsWriterRunning) {
  schedule = std::make_unique<Schedule>(ScheduleMode::onChange);
  Answers cycle, relax;
  cycle.purpose = true;
  add<Quantity::cellStates, Quantity::agentPositions>("relax", relax);
  add<Quantity::agentPositions, Quantity::cellStates>("cycle", cycle);
  schedule->advance({});
  EXPECT_EQ(relax.runs, 1);
  EXPECT_EQ(cycle.runs, 1);
}

TEST_F(ScheduleTest, NotesWhatAPartThatRanHasRead) {
  build(ScheduleMode::onChange);
  flow.changed = Verdict::skip("lumen moved less than its tolerance");
  schedule->advance({});
  const auto* ran = schedule->find<FakePart<Quantity::agentPositions, Quantity::lumen>>();
  const auto* skipped = schedule->find<FakePart<Quantity::lumen, Quantity::wallShearStress>>();
  ASSERT_TRUE(ran && skipped);
  EXPECT_FALSE(ran->hasNewInput());
  EXPECT_TRUE(skipped->hasNewInput());
}

/// A step that is killed in a part that takes long: what was saved before it goes on with that part.
TEST_F(ScheduleTest, AStateSavedBeforeALongPartGoesOnWithIt) {
  build(ScheduleMode::onChange);
  flow.takesLong = flow.fails = true;
  std::string saved;
  const auto save = [&] {
    WritingArchive state;
    state(*schedule);
    saved = state.buffer();
  };
  EXPECT_THROW(schedule->advance({}, save), std::runtime_error);
  EXPECT_EQ(surface.runs, 1);

  build(ScheduleMode::onChange);
  flow.fails = false;
  ReadingArchive state(saved);
  state(*schedule);
  schedule->advance({});
  EXPECT_EQ(surface.runs, 1) << "it had run";
  EXPECT_EQ(flow.runs, 1);
  EXPECT_EQ(nitricOxide.runs, 1);
  EXPECT_EQ(schedule->counts().at("surface").done, 1u);
  schedule->advance({});
  EXPECT_EQ(surface.runs, 2) << "the next step is a whole one";
}

TEST_F(ScheduleTest, SavesNothingBeforeALongPartThatIsNotDue) {
  build(ScheduleMode::onChange);
  flow.takesLong = true;
  flow.changed = Verdict::skip("lumen moved less than its tolerance");
  schedule->advance({}, [] { FAIL() << "it does not run"; });
}

}  // namespace
}  // namespace restenosis

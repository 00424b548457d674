#include <gtest/gtest.h>

#include "bridge/coupling/Part.h"
#include "tissue/agents/StateArchive.h"

namespace restenosis {
namespace {

/// Reads the lumen and coverage, writes exposure, looks at nitric oxide.
struct DeclaringPart : Part {
  using Part::Part;
  std::string_view name() const override { return "declaring"; }
  void run(const Instant&) override {}

  Read<Quantity::lumen> lumen = read<Quantity::lumen>();
  Read<Quantity::coverage> coverage = read<Quantity::coverage>();
  Write<Quantity::exposure> exposure = write<Quantity::exposure>();
  Read<Quantity::nitricOxide> nitricOxide = observe<Quantity::nitricOxide>();
};

struct PartTest : ::testing::Test {
  Quantities quantities{Wall()};
  DeclaringPart part{quantities};
};

TEST_F(PartTest, readsAndWritesWhatItHasDeclared) {
  EXPECT_EQ(part.reads(), (std::vector{Quantity::lumen, Quantity::coverage}));
  EXPECT_EQ(part.writes(), (std::vector{Quantity::exposure}));
}

TEST_F(PartTest, whatWasNeverReadIsNew) { EXPECT_TRUE(part.hasNewInput()); }

TEST_F(PartTest, whatWasReadIsOldUntilItChangesAgain) {
  part.noteInputs();
  EXPECT_FALSE(part.hasNewInput()) << "what never changed can be read too";
  quantities.countChange(Quantity::coverage);
  EXPECT_TRUE(part.hasNewInput());
  quantities.countChange(Quantity::coverage);  // one reading is enough for both
  part.noteInputs();
  EXPECT_FALSE(part.hasNewInput());
}

TEST_F(PartTest, whatItWritesOrLooksAtIsNoInput) {
  part.noteInputs();
  part.exposure.change([](AgentStore&) {});
  quantities.countChange(Quantity::nitricOxide);
  EXPECT_FALSE(part.hasNewInput());
}

TEST_F(PartTest, onePartsReadingIsNotAnothers) {
  DeclaringPart other(quantities);
  other.noteInputs();
  EXPECT_TRUE(part.hasNewInput());
  EXPECT_FALSE(other.hasNewInput());
}

TEST_F(PartTest, aCheckpointKeepsWhatWasRead) {
  quantities.countChange(Quantity::lumen);
  part.noteInputs();
  WritingArchive writing;
  writing(part);
  DeclaringPart resumed(quantities);
  ReadingArchive reading(writing.buffer());
  reading(resumed);
  EXPECT_TRUE(reading.atEnd());
  EXPECT_FALSE(resumed.hasNewInput());
  quantities.countChange(Quantity::lumen);
  EXPECT_TRUE(resumed.hasNewInput());
}

TEST_F(PartTest, aVerdictIsNoWhereThereIsAReason) {
  EXPECT_TRUE(Verdict::unless("").yes);
  const Verdict no = Verdict::unless("nothing moved");
  EXPECT_FALSE(no.yes);
  EXPECT_EQ(no.reason, "nothing moved");
}

}  // namespace
}  // namespace restenosis

#include <gtest/gtest.h>

#include "bridge/coupling/ChangeLedger.h"
#include "tissue/agents/StateArchive.h"

namespace restenosis {
namespace {

TEST(ChangeLedger, APartThatNeverReadHasSomethingToRead) {
  const ChangeLedger ledger;
  EXPECT_TRUE(ledger.changedSince("flow", Quantity::lumen));
}

TEST(ChangeLedger, WhatWasReadIsOldUntilItChangesAgain) {
  ChangeLedger ledger;
  ledger.touch(Quantity::lumen);
  ledger.markRead("flow", Quantity::lumen);
  EXPECT_FALSE(ledger.changedSince("flow", Quantity::lumen));
  ledger.touch(Quantity::lumen);
  EXPECT_TRUE(ledger.changedSince("flow", Quantity::lumen));
  ledger.touch(Quantity::lumen);  // one reading is enough for both
  ledger.markRead("flow", Quantity::lumen);
  EXPECT_FALSE(ledger.changedSince("flow", Quantity::lumen));
}

TEST(ChangeLedger, WhatNeverChangedCanBeReadToo) {
  ChangeLedger ledger;
  ledger.markRead("flow", Quantity::lumen);
  EXPECT_FALSE(ledger.changedSince("flow", Quantity::lumen));
  ledger.touch(Quantity::lumen);
  EXPECT_TRUE(ledger.changedSince("flow", Quantity::lumen));
}

TEST(ChangeLedger, PartsAndQuantitiesAreKeptApart) {
  ChangeLedger ledger;
  for (const Quantity quantity : {Quantity::lumen, Quantity::coverage}) {
    ledger.touch(quantity);
    for (const char* part : {"flow", "flowing"}) ledger.markRead(part, quantity);
  }
  ledger.touch(Quantity::lumen);
  EXPECT_TRUE(ledger.changedSince("flow", Quantity::lumen));
  EXPECT_FALSE(ledger.changedSince("flow", Quantity::coverage));
  ledger.markRead("flow", Quantity::lumen);
  EXPECT_FALSE(ledger.changedSince("flow", Quantity::lumen));
  EXPECT_TRUE(ledger.changedSince("flowing", Quantity::lumen)) << "one part's reading is not another's";
}

TEST(ChangeLedger, ACheckpointKeepsWhatWasRead) {
  ChangeLedger ledger;
  ledger.touch(Quantity::lumen);
  ledger.touch(Quantity::coverage);
  ledger.markRead("flow", Quantity::lumen);
  ledger.markRead("sampling", Quantity::coverage);
  ledger.touch(Quantity::coverage);
  WritingArchive writing;
  writing(ledger);

  ChangeLedger resumed;
  resumed.touch(Quantity::exposure);
  resumed.markRead("flow", Quantity::exposure);
  ReadingArchive reading(writing.buffer());
  reading(resumed);
  EXPECT_TRUE(reading.atEnd());
  EXPECT_FALSE(resumed.changedSince("flow", Quantity::lumen));
  EXPECT_TRUE(resumed.changedSince("sampling", Quantity::coverage));
  EXPECT_TRUE(resumed.changedSince("flow", Quantity::exposure)) << "nothing of its own is left";
  resumed.touch(Quantity::lumen);
  EXPECT_TRUE(resumed.changedSince("flow", Quantity::lumen));
}

}  // namespace
}  // namespace restenosis

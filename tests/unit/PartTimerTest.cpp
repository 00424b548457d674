#include <gtest/gtest.h>

#include <thread>
#include <vector>

#include "bridge/output/PartTimer.h"
#include "tissue/agents/StateArchive.h"

namespace restenosis {
namespace {

void wait(int milliseconds) { std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds)); }

TEST(PartTimer, CountsAnInnerPartOnce) {
  PartTimer timer;
  const auto start = std::chrono::steady_clock::now();
  {
    const auto outer = timer.measure("flow");
    wait(10);
    {
      const auto inner = timer.measure("surface");
      wait(20);
    }
    wait(10);
  }
  const double elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  EXPECT_GE(timer.costs().at("flow").seconds, 0.02);
  EXPECT_GE(timer.costs().at("surface").seconds, 0.02);
  EXPECT_LE(timer.totalSeconds(), elapsed);
  EXPECT_EQ(timer.costs().at("flow").calls, 1u);
}

TEST(PartTimer, FindsThePeakMemoryOfItsPart) {
  constexpr std::size_t size = 64 << 20;
  PartTimer timer;
  { const auto part = timer.measure("small"); }
  {
    const auto part = timer.measure("large");
    const std::vector<char> memory(size, 1);
    ASSERT_EQ(memory.back(), 1);
  }
  EXPECT_GE(timer.costs().at("large").peakMemory, size);
  EXPECT_GE(timer.costs().at("large").peakMemory, timer.costs().at("small").peakMemory);
}

TEST(PartTimer, BooksSecondsToAnotherPart) {
  PartTimer timer;
  {
    const auto part = timer.measure("flow");
    wait(5);
  }
  const double before = timer.totalSeconds();
  timer.transfer("flow", "mesh", 0.004);
  EXPECT_DOUBLE_EQ(timer.costs().at("mesh").seconds, 0.004);
  EXPECT_NEAR(timer.totalSeconds(), before, 1e-12);
}

TEST(PartTimer, GivesThePeakOfAPartStillMeasuredToAnother) {
  PartTimer timer;
  {
    const auto part = timer.measure("flow");
    timer.transfer("flow", "mesh", 0);
  }
  EXPECT_GT(timer.costs().at("mesh").peakMemory, 0u);
}

TEST(PartTimer, AddsUpOverAResume) {
  PartTimer first;
  {
    const auto part = first.measure("relax");
    wait(5);
  }
  WritingArchive checkpoint;
  checkpoint(first);
  PartTimer second;
  ReadingArchive stored(checkpoint.buffer());
  stored(second);
  {
    const auto part = second.measure("relax");
    wait(5);
  }
  EXPECT_GE(second.costs().at("relax").seconds, first.costs().at("relax").seconds + 0.005);
  EXPECT_EQ(second.costs().at("relax").calls, 2u);
}

}  // namespace
}  // namespace restenosis

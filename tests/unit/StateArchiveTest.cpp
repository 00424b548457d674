#include <gtest/gtest.h>

#include "tissue/agents/StateArchive.h"

namespace restenosis {
namespace {

/// One of each kind of value that an archive knows.
struct ArchivedSample {
  double number = 0;
  std::string text;
  std::vector<std::int32_t> plain;
  std::vector<std::string> texts;
  std::map<std::string, std::uint64_t> counts;
  std::optional<double> note;

  template <class Archive>
  void archive(Archive& a) {
    a(number, text, plain, texts, counts, note);
  }
  bool operator==(const ArchivedSample&) const = default;
};

ArchivedSample fullSample() {
  return {2.5, "words", {1, 2, 3}, {"a", "bc", ""}, {{"first", 1}, {"second", 2}}, 0.5};
}

std::string writtenState(ArchivedSample sample) {
  WritingArchive archive;
  archive(sample);
  return archive.buffer();
}

TEST(StateArchive, ReadsWhatWasWrittenIntoAnything) {
  const ArchivedSample empty;
  // Containers that grow, shrink, and hold as many but other things.
  ArchivedSample larger = fullSample();
  larger.plain.resize(9);
  larger.texts.resize(9, "x");
  larger.counts = {{"a", 1}, {"b", 2}, {"c", 3}};
  ArchivedSample others = fullSample();
  others.counts = {{"third", 3}, {"fourth", 4}};
  others.note = -0.5;
  for (const ArchivedSample& stored : {empty, fullSample(), larger, others}) {
    for (ArchivedSample target : {empty, fullSample(), larger, others}) {
      ReadingArchive reading(writtenState(stored));
      reading(target);
      EXPECT_EQ(target, stored);
      EXPECT_TRUE(reading.atEnd());
    }
  }
}

TEST(StateArchive, WritingAndHashingLeaveTheStateAsItIs) {
  ArchivedSample sample = fullSample();
  WritingArchive writing;
  writing(sample);
  HashingArchive hashing;
  hashing(sample);
  EXPECT_EQ(sample, fullSample());
}

TEST(StateArchive, EveryTruncationIsRefused) {
  const std::string whole = writtenState(fullSample());
  for (std::size_t size = 0; size < whole.size(); ++size) {
    ReadingArchive reading(whole.substr(0, size));
    ArchivedSample target;
    EXPECT_THROW(reading(target), ArchiveTruncated) << size << " of " << whole.size() << " bytes";
  }
}

TEST(StateArchive, ACountBeyondTheBufferIsRefusedBeforeRoomIsMadeForIt) {
  WritingArchive writing;
  std::uint64_t damaged = std::uint64_t{1} << 60;
  writing(damaged);
  std::vector<double> values;
  std::string text;
  std::map<std::string, int> map;
  EXPECT_THROW(ReadingArchive{writing.buffer()}(values), ArchiveTruncated);
  EXPECT_THROW(ReadingArchive{writing.buffer()}(text), ArchiveTruncated);
  EXPECT_THROW(ReadingArchive{writing.buffer()}(map), ArchiveTruncated);
}

TEST(StateArchive, WhatIsLeftOverIsSeen) {
  ReadingArchive reading(writtenState(fullSample()) + 'x');
  ArchivedSample target;
  reading(target);
  EXPECT_FALSE(reading.atEnd());
}

TEST(StateArchive, StreamingAndHashingSeeTheBytesThatAreWritten) {
  ArchivedSample sample = fullSample();
  const std::string written = writtenState(sample);
  std::string streamed;
  StreamingArchive streaming([&](std::string_view piece) { streamed += piece; });
  streaming(sample);
  EXPECT_EQ(streamed, written);

  HashingArchive hashing;
  hashing(sample);
  EXPECT_EQ(hashing.digest(), digestOf(written));
  EXPECT_EQ(hashing.digest().size(), 16u);
}

TEST(StateArchive, EveryValueCounts) {
  const std::string reference = digestOf(writtenState(fullSample()));
  for (const auto& change : std::vector<std::function<void(ArchivedSample&)>>{
           [](auto& s) { s.number = -s.number; }, [](auto& s) { s.text = "word"; },
           [](auto& s) { s.plain[2] = 4; }, [](auto& s) { std::swap(s.texts[0], s.texts[1]); },
           [](auto& s) { s.counts["second"] = 3; }, [](auto& s) { s.note.reset(); }}) {
    ArchivedSample sample = fullSample();
    change(sample);
    EXPECT_NE(digestOf(writtenState(sample)), reference);
  }
}

}  // namespace
}  // namespace restenosis

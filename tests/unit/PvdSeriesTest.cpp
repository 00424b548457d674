#include <gtest/gtest.h>
#include <unistd.h>

#include "bridge/output/PvdSeries.h"
#include "bridge/output/ResultsFolder.h"
#include "tests/support/TemporaryFolder.h"
#include "tissue/agents/StateArchive.h"

namespace restenosis {
namespace {

namespace fs = std::filesystem;

void addFrame(PvdSeries& series, std::uint64_t step) {
  writeText(series.dataFile(step), "data");
  series.add(step, 3600.0 * static_cast<double>(step));
}

std::size_t occurrences(const std::string& text, const std::string& word) {
  std::size_t count = 0;
  for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++count;
  return count;
}

TEST(PvdSeries, NamesItsFilesByDay) {
  TemporaryFolder folder;
  PvdSeries series(folder.path(), "tissue");
  series.begin();
  EXPECT_EQ(occurrences(readText(series.index()), "<DataSet"), 0u);
  addFrame(series, 0), addFrame(series, 36);
  const auto text = readText(series.index());
  EXPECT_NE(text.find("timestep=\"1.5\" group=\"\" part=\"0\" file=\"tissue/tissue_000036.vtp\""),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("</VTKFile>"), std::string::npos);
}

TEST(PvdSeries, IsCutBackToTheCheckpointOnResume) {
  TemporaryFolder folder;
  PvdSeries series(folder.path(), "lumen");
  series.begin();
  addFrame(series, 0), addFrame(series, 24);
  WritingArchive checkpoint;
  checkpoint(series);
  addFrame(series, 48);
  writeText(folder / "lumen/lumen_000072.vtp.partial", "half");
  writeText(folder / "lumen/notes.md", "mine");

  PvdSeries resumed(folder.path(), "lumen");
  ReadingArchive stored(checkpoint.buffer());
  stored(resumed);
  resumed.begin();
  EXPECT_EQ(resumed.size(), 2u);
  EXPECT_EQ(occurrences(readText(resumed.index()), "<DataSet"), 2u);
  EXPECT_TRUE(fs::exists(resumed.dataFile(24)));
  EXPECT_FALSE(fs::exists(resumed.dataFile(48)));
  EXPECT_FALSE(fs::exists(folder / "lumen/lumen_000072.vtp.partial"));
  EXPECT_TRUE(fs::exists(folder / "lumen/notes.md"));
}

TEST(PvdSeries, LeavesOutFilesThatAreGoneOnResume) {
  TemporaryFolder folder;
  PvdSeries series(folder.path(), "lumen");
  series.begin();
  addFrame(series, 0), addFrame(series, 24);
  fs::remove(series.dataFile(0));
  series.begin();
  EXPECT_EQ(series.size(), 1u);
  const auto text = readText(series.index());
  EXPECT_EQ(occurrences(text, "lumen_000000.vtp"), 0u);
  EXPECT_EQ(occurrences(text, "lumen_000024.vtp"), 1u);
}

TEST(PvdSeries, RefusesADataFolderThatMayNotBeRead) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may read everything";
  TemporaryFolder folder;
  PvdSeries series(folder.path(), "lumen");
  series.begin();
  addFrame(series, 0);
  const auto index = readText(series.index());
  fs::permissions(folder / "lumen", fs::perms::none);
  EXPECT_THROW(series.begin(), FolderRefused);
  fs::permissions(folder / "lumen", fs::perms::owner_all);
  EXPECT_EQ(readText(series.index()), index);
}

}  // namespace
}  // namespace restenosis

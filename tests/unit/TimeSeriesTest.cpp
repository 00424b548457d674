#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "bridge/output/TimeSeries.h"
#include "bridge/system/AtomicFile.h"
#include "tests/support/FileSizeLimit.h"
#include "tests/support/TemporaryFolder.h"
#include "tissue/agents/StateArchive.h"

namespace restenosis {
namespace {

constexpr const char* contract =
    "day,agents,smc,divisions,neointimaThickness_um,neointimaAreaFraction,minLumenArea_mm2,coverage,wssMean_"
    "Pa,"
    "wssLowAreaFraction,flowSolved";

TimeSeriesRow rowAt(double day) {
  TimeSeriesRow row;
  row.time = 86400 * day;
  row.agents = 70000, row.smc = 60000, row.divisions = 12;
  row.neointimaThickness = 34.5e-6;
  row.neointimaAreaFraction = 0.125;
  row.minLumenArea = 2.25e-6;
  row.coverage = 0.59;
  return row;
}

TEST(TimeSeries, WritesTheContractsColumnsInTheirUnits) {
  TemporaryFolder folder;
  TimeSeries series(folder / "timeSeries.csv");
  series.begin();
  auto row = rowAt(1.5);
  row.wssMean = 1.6, row.wssLowAreaFraction = 0.25, row.flowSolved = 1;
  series.append(row);
  const auto text = readText(folder / "timeSeries.csv");
  EXPECT_TRUE(text.starts_with(std::string(contract) + ","));
  EXPECT_NE(text.find("\n1.5,70000,60000,12,34.5,0.125,2.25,0.59,1.6,0.25,1,"), std::string::npos) << text;
}

TEST(TimeSeries, LeavesFieldsEmptyThatAreNotKnown) {
  TemporaryFolder folder;
  TimeSeries series(folder / "timeSeries.csv");
  series.begin();
  series.append(rowAt(0));
  const auto text = readText(folder / "timeSeries.csv");
  EXPECT_NE(text.find("0.59,,,0,"), std::string::npos) << text;
}

TEST(TimeSeries, EveryRowHasAsManyFieldsAsTheHeader) {
  TemporaryFolder folder;
  TimeSeries series(folder / "timeSeries.csv");
  series.begin();
  series.append(rowAt(0));
  std::istringstream lines(readText(folder / "timeSeries.csv"));
  std::string header, row;
  std::getline(lines, header), std::getline(lines, row);
  EXPECT_EQ(std::ranges::count(header, ','), std::ranges::count(row, ','));
}

TEST(TimeSeries, NamesTheColumnThatIsNotFinite) {
  TemporaryFolder folder;
  TimeSeries series(folder / "timeSeries.csv");
  series.begin();
  auto row = rowAt(2);
  row.coverage = std::numeric_limits<double>::quiet_NaN();
  try {
    series.append(row);
    FAIL() << "wrote NaN";
  } catch (const WriteFailed& error) {
    EXPECT_NE(std::string(error.what()).find("day 2, column coverage"), std::string::npos) << error.what();
  }
}

TEST(TimeSeries, IsCutBackToTheCheckpointOnResume) {
  TemporaryFolder folder;
  WritingArchive checkpoint;
  {
    TimeSeries series(folder / "timeSeries.csv");
    series.begin();
    series.append(rowAt(0)), series.append(rowAt(1));
    checkpoint(series);
    series.append(rowAt(2)), series.append(rowAt(3));
  }
  std::ofstream(folder / "timeSeries.csv", std::ios::app) << "4,700";
  TimeSeries resumed(folder / "timeSeries.csv");
  ReadingArchive stored(checkpoint.buffer());
  stored(resumed);
  resumed.begin();
  resumed.append(rowAt(2));

  TimeSeries uninterrupted(folder / "reference.csv");
  uninterrupted.begin();
  for (const double day : {0, 1, 2}) uninterrupted.append(rowAt(day));
  EXPECT_EQ(readText(folder / "timeSeries.csv"), readText(folder / "reference.csv"));
  EXPECT_EQ(resumed.rows().size(), 3u);
}

TEST(TimeSeries, DetectsAFullDisk) {
  TemporaryFolder folder;
  TimeSeries series(folder / "timeSeries.csv");
  series.begin();
  FileSizeLimit full(std::filesystem::file_size(folder / "timeSeries.csv"));
  EXPECT_THROW(series.append(rowAt(0)), WriteFailed);
}

}  // namespace
}  // namespace restenosis

#include <gtest/gtest.h>

#include <algorithm>

#include "bridge/output/TradeoffRows.h"
#include "tests/support/TemporaryFolder.h"

namespace restenosis {
namespace {

const std::vector<TradeoffRow> rows = {{"flow", "foam draft", 5.25, 0.0125, "stress against another"},
                                       {"scene.seed", "2", 60, 0, "thickness against scene.seed = 1"}};

TEST(TradeoffRows, AreWrittenAsCsv) {
  TemporaryFolder folder;
  writeTradeoffCsv(folder / "tradeoff.csv", rows);
  EXPECT_EQ(readText(folder / "tradeoff.csv"),
            "setting,value,seconds,error,meaning\n"
            "flow,foam draft,5.25,0.0125,stress against another\n"
            "scene.seed,2,60,0,thickness against scene.seed = 1\n");
}

TEST(TradeoffRows, AreShownWithErrorsInPercent) {
  const std::string table = tradeoffTable(rows);
  EXPECT_NE(table.find("1.250"), std::string::npos) << table;
  EXPECT_EQ(std::ranges::count(table, '\n'), 3);
}

TEST(TradeoffRows, NameFoldersWithoutSpaces) {
  EXPECT_EQ(withoutSpaces("coupling.lumenTolerance = 5 um"), "coupling.lumenTolerance=5um");
}

}  // namespace
}  // namespace restenosis

#include "bridge/output/TradeoffRows.h"

#include <fmt/format.h>

#include <algorithm>

#include "bridge/output/CsvText.h"
#include "bridge/system/AtomicFile.h"

namespace restenosis {

std::string withoutSpaces(std::string name) {
  // A value such as 0.1 m/s is no folder in a folder
  std::ranges::replace(name, '/', '_');
  std::erase(name, ' ');
  return name;
}

void writeTradeoffCsv(const std::filesystem::path& file, const std::vector<TradeoffRow>& rows) {
  CsvText csv;
  for (const char* name : {"setting", "value", "seconds", "error", "meaning"}) csv.field(name);
  csv.endLine();
  for (const TradeoffRow& row : rows) {
    csv.field(row.setting);
    csv.field(row.value);
    csv.field(row.seconds);
    csv.field(row.error);
    csv.field(row.meaning);
    csv.endLine();
  }
  atomicWrite(file, csv.text());
}

std::string tradeoffTable(const std::vector<TradeoffRow>& rows) {
  std::string table =
      fmt::format("{:<28}{:<14}{:>10}{:>12}   {}\n", "setting", "value", "seconds", "error [%]", "error of");
  for (const TradeoffRow& row : rows)
    table += fmt::format("{:<28}{:<14}{:>10.2f}{:>12.3f}   {}\n", row.setting, row.value, row.seconds,
                         100 * row.error, row.meaning);
  return table;
}

}  // namespace restenosis

#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace restenosis {

/// What one value of one setting costs and how far its answer is off.
struct TradeoffRow {
  std::string setting, value;
  double seconds = 0.0;  ///< by wall clock
  double error = 0.0;    ///< relative
  std::string meaning;   ///< of the error: of what, against what
};

/// A name for one folder: OpenFOAM takes no spaces in paths, and a slash would make two.
std::string withoutSpaces(std::string name);

/// Writes tradeoff.csv: setting, value, seconds, error, meaning. Throws WriteFailed.
void writeTradeoffCsv(const std::filesystem::path& file, const std::vector<TradeoffRow>& rows);

/// The same as a table for people, errors in percent.
std::string tradeoffTable(const std::vector<TradeoffRow>& rows);

}  // namespace restenosis

#include "tissue/parameters/CsvLines.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "tissue/parameters/Trimmed.h"

namespace restenosis {
namespace {

constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";

}  // namespace

std::string_view cellOf(std::string_view text) { return trimmed(text, " \t\r\""); }

std::optional<double> finiteNumber(std::string_view cell) {
  double value = 0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (error != std::errc() || end != cell.data() + cell.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

CsvLines::CsvLines(const std::filesystem::path& file) : file_(file), stream_(file) {
  if (!stream_) failWhole("cannot be opened");
}

std::optional<std::string_view> CsvLines::readLine() {
  if (!rest_) {
    if (!std::getline(stream_, buffer_)) return std::nullopt;
    rest_ = buffer_;
    if (rest_->ends_with('\r')) rest_->remove_suffix(1);
  }
  const auto end = rest_->find('\r');
  const std::string_view line = rest_->substr(0, end);
  if (end == std::string_view::npos)
    rest_.reset();
  else
    rest_->remove_prefix(end + 1);
  return line;
}

bool CsvLines::next() {
  while (auto line = readLine()) {
    if (++number_ == 1 && line->starts_with(byteOrderMark)) line->remove_prefix(byteOrderMark.size());
    text_ = cellOf(line->substr(0, line->find('#')));
    if (!text_.empty()) return true;
  }
  if (stream_.bad()) fail("cannot be read any further");
  return false;
}

std::vector<std::string_view> CsvLines::cells() const {
  std::vector<std::string_view> cells;
  for (std::string_view rest = text_;;) {
    const auto comma = rest.find(',');
    cells.push_back(cellOf(rest.substr(0, comma)));
    if (comma == std::string_view::npos) return cells;
    rest.remove_prefix(comma + 1);
  }
}

void CsvLines::fail(const std::string& message) const {
  throw TableError(fmt::format("{}:{}: {}", file_.string(), number_, message));
}

void CsvLines::failWhole(const std::string& message) const {
  throw TableError(fmt::format("{}: {}", file_.string(), message));
}

}  // namespace restenosis

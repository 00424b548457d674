#include "bridge/output/TimeSeries.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>

#include "bridge/output/CsvText.h"
#include "bridge/system/AtomicFile.h"
#include "tissue/parameters/SecondsPerDay.h"

namespace restenosis {

namespace {

void addHeader(CsvText& csv) {
  TimeSeriesRow().forEachColumn([&csv](const char* column, const auto&, double) { csv.field(column); });
  csv.endLine();
}

void addRow(CsvText& csv, const TimeSeriesRow& row) {
  row.forEachColumn([&csv, &row](const char* column, const auto& value, double scale) {
    if constexpr (std::is_same_v<std::decay_t<decltype(value)>, std::uint64_t>) {
      csv.field(value);
    } else {
      try {
        csv.field(value, scale);
      } catch (const std::invalid_argument& error) {
        throw WriteFailed(fmt::format("time series, day {:.4g}, column {}: {}", row.time / secondsPerDay,
                                      column, error.what()));
      }
    }
  });
  csv.endLine();
}

}  // namespace

void TimeSeries::begin() {
  CsvText csv;
  addHeader(csv);
  for (const auto& row : rows_) addRow(csv, row);
  stream_.close();
  atomicWrite(file_, csv.text());
  stream_.open(file_, std::ios::app);
  if (!stream_)
    throw WriteFailed(
        fmt::format("cannot open {} to add rows: {}", file_.string(), writeFailureReason(errno)));
}

void TimeSeries::end() {
  stream_.close();
  if (!stream_) throw WriteFailed(fmt::format("cannot write {}: {}", file_.string(), std::strerror(errno)));
  flushFile(file_);
}

void TimeSeries::append(const TimeSeriesRow& row) {
  CsvText csv;
  addRow(csv, row);
  stream_ << csv.text() << std::flush;
  if (!stream_) throw WriteFailed(fmt::format("cannot add a row to {}: is the disk full?", file_.string()));
  rows_.push_back(row);
}

}  // namespace restenosis

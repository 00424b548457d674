#pragma once

#include <filesystem>
#include <fstream>
#include <vector>

#include "bridge/output/TimeSeriesRow.h"

namespace restenosis {

/// timeSeries.csv: one row a recorded step, in the file as soon as `append` returns. The rows are part of a
/// checkpoint, so that after a resume the file has exactly the rows up to the checkpoint and goes on.
class TimeSeries {
 public:
  explicit TimeSeries(std::filesystem::path file) : file_(std::move(file)) {}

  /// Writes the file anew from the rows held: none in a fresh run, those of the checkpoint after `archive`.
  /// Throws WriteFailed.
  void begin();
  /// Closes the file and has it on the disk. Throws WriteFailed.
  void end();
  /// Adds a row; `begin` comes first. Throws WriteFailed, naming the column when a value is not finite.
  void append(const TimeSeriesRow& row);

  const std::vector<TimeSeriesRow>& rows() const { return rows_; }

  template <class Archive>
  void archive(Archive& a) {
    a(rows_);
  }

 private:
  std::filesystem::path file_;
  std::ofstream stream_;
  std::vector<TimeSeriesRow> rows_;
};

}  // namespace restenosis

#pragma once

#include <cstdint>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace restenosis {

/// A time series for ParaView: `<name>.pvd` in the results folder, its data files in the folder `<name>/`.
/// The index names only files that are complete, at every moment: write `dataFile(step)` first, then `add`
/// it.
class PvdSeries {
 public:
  PvdSeries(std::filesystem::path folder, std::string name)
      : folder_(std::move(folder)), name_(std::move(name)) {}

  /// Creates the data folder and writes the index anew from the entries held: none in a fresh run, those of
  /// the checkpoint after `archive`, less those whose file is gone. Data files that it does not name are
  /// removed. Throws WriteFailed, or FolderRefused where the data folder cannot be read.
  void begin();
  std::filesystem::path dataFile(std::uint64_t step) const;
  /// Adds the data file of a step at `time` [s]; the index counts in days. Throws WriteFailed.
  void add(std::uint64_t step, double time);

  std::filesystem::path index() const { return folder_ / (name_ + ".pvd"); }
  std::size_t size() const { return entries_.size(); }

  template <class Archive>
  void archive(Archive& a) {
    a(entries_);
  }

 private:
  struct Entry {
    std::uint64_t step;
    double time;
  };
  std::string relativeFile(std::uint64_t step) const;
  /// What lies in the data folder under names of this series.
  std::set<std::filesystem::path> ownFiles() const;
  void write() const;

  std::filesystem::path folder_;
  std::string name_;
  std::vector<Entry> entries_;
};

}  // namespace restenosis

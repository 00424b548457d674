#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "bridge/output/FormerRun.h"

namespace restenosis {

/// A folder that a run may not use; `what()` says why and what to do.
struct FolderRefused : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Creates the folder that a user has asked for, and those above it, and marks it as this program's; throws
/// FolderRefused where it cannot be, or holds files of something else.
void createOutputFolder(const std::filesystem::path& folder);

/// The folder of a run's results: knows the place of every file, and holds a lock while it lives, so that no
/// two runs write into one folder (the system releases the lock when the process ends in any way).
///
/// A fresh run into a results folder of this program moves the former run's files to `previous/`, replacing
/// the run that is there, and leaves every other file alone; a former run that has recorded nothing does not
/// replace one that has, but is deleted. A move that was cut short is finished by whoever uses the folder
/// next. A folder with files, but without a run of this program, is refused.
///
/// Symbolic links among the results are not followed: where a folder of results is one, the results folder is
/// refused, and a file that is one is replaced. The results folder itself may be a link.
class ResultsFolder {
 public:
  /// For a new run: creates the folder, or clears it of the former run. Throws FolderRefused, also where the
  /// folder cannot be made or written into, or WriteFailed.
  static ResultsFolder fresh(const std::filesystem::path& folder);
  /// For a run to go on with, or to be looked at: everything stays. Throws FolderRefused when it is no
  /// results folder.
  static ResultsFolder existing(const std::filesystem::path& folder);
  /// For a run to go on with, which may have been killed before it made its folder: the same, but a folder
  /// that is not there, or empty, is that of a new run.
  static ResultsFolder resumed(const std::filesystem::path& folder);
  /// For the results of a comparison or a sweep, some of which are in folders of their own:
  /// createOutputFolder, and the lock.
  static ResultsFolder forOutput(const std::filesystem::path& folder);

  /// Whether a folder is marked as one of results.
  static bool isMarked(const std::filesystem::path& folder);

  /// Whether a file is part of the results in `folder`, which a new run moves aside or removes.
  static bool holdsAsResult(const std::filesystem::path& folder, const std::filesystem::path& file);

  /// Moves the former run's files to `previous/`, as for a new run; tells whether there was one that has been
  /// moved. Throws WriteFailed.
  bool moveFormerRun(Unrecorded unrecorded = Unrecorded::keptUnlessItReplaces) const;

  ResultsFolder(ResultsFolder&& other) noexcept;
  ResultsFolder& operator=(ResultsFolder&&) = delete;
  ~ResultsFolder();

  const std::filesystem::path& path() const { return folder_; }
  std::filesystem::path scene() const { return folder_ / "scene.toml"; }
  std::filesystem::path timeSeries() const { return folder_ / "timeSeries.csv"; }
  std::filesystem::path profile() const { return folder_ / "profile.csv"; }
  std::filesystem::path thicknessMap() const { return folder_ / "thicknessMap.csv"; }
  std::filesystem::path summary() const { return folder_ / "summary.json"; }
  std::filesystem::path checkpoint() const { return folder_ / "checkpoint"; }
  /// The OpenFOAM case of the solve at `time` [s] since deployment: flow/<day>, the day with as many decimals
  /// as it needs, five at most ("flow/3", "flow/3.125"): steps of a second have folders of their own.
  std::filesystem::path flowCase(double time) const;
  /// What another method leaves of its solve at `time`: crossCheck/<day>.
  std::filesystem::path crossCheckCase(double time) const;
  /// Removes all of these but one; what is not named after a day stays.
  void removeCrossChecksBut(const std::filesystem::path& wanted) const;
  /// Removes the cases of later solves than the one at `time` [s], or of all. What in flow/ is not named
  /// after a day is the user's and stays.
  void removeFlowCasesAfter(std::optional<double> time) const;
  /// Likewise removes all cases but these. Of a removed case the folders that hold nothing but logs (log.*)
  /// stay: they are of attempts that failed, and remarks name them.
  void removeFlowCasesBut(std::span<const std::filesystem::path> wanted) const;

 private:
  ResultsFolder(std::filesystem::path folder, int lock) : folder_(std::move(folder)), lock_(lock) {}
  static int acquireLock(const std::filesystem::path& folder);
  /// Those in `folder` that unwanted(case, day) is true of.
  template <class Unwanted>
  std::vector<std::filesystem::path> cases(const char* folder, Unwanted&& unwanted) const;

  std::filesystem::path folder_;
  int lock_;
};

}  // namespace restenosis

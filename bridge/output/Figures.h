#pragma once

#include <atomic>
#include <chrono>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace restenosis {

/// Draws the pictures of a results folder (vessel.png, section.png, growth.png, lumen.png, lumen3d.png), or
/// of a comparison of backends (compareMaps.png, compareScatter.png), by running the Python package `figures`
/// on it as a process of its own. Pictures never fail a run.
class Figures {
 public:
  /// The interpreter is RESTENOSIS_PYTHON where set, else /usr/bin/python3, whose packages Debian provides.
  Figures();
  Figures(std::string interpreter, std::filesystem::path script, std::chrono::seconds limit);

  /// Returns what kept pictures from being drawn, in a sentence for the user that names the package to
  /// install or the log to read (figures.log); empty when all were drawn. Gives up once `stopRequested` is
  /// true; null: never.
  std::string draw(const std::filesystem::path& results,
                   const std::atomic<bool>* stopRequested = nullptr) const;

  /// Draws animation.gif, vessel.png day by day, of a run that has tissue. Returns what kept it from being
  /// drawn, as `draw` does.
  std::string animate(const std::filesystem::path& results,
                      const std::atomic<bool>* stopRequested = nullptr) const;

  /// Writes one page of a run, or of several runs and studies side by side, to `page`. Returns what kept it
  /// from being written, as `draw` does; the log is beside the page until it is written.
  std::string writePage(std::span<const std::filesystem::path> results, const std::filesystem::path& page,
                        const std::atomic<bool>* stopRequested = nullptr) const;

 private:
  /// What is asked of the package.
  struct Task {
    std::string what;        ///< "pictures"
    std::string incomplete;  ///< what is said where it fails: "not all pictures were drawn"
    std::vector<std::string> arguments;
    std::filesystem::path folder;  ///< that the task may use, and removes
    std::filesystem::path log;
    bool keepsLog = false;  ///< also where all went well
    int longer = 1;         ///< it may take so many times as long as others
  };
  /// Has it done; returns what went wrong, empty where nothing did.
  std::string run(const Task& task, const std::atomic<bool>* stopRequested) const;

  std::string interpreter_;
  std::filesystem::path script_;
  std::chrono::seconds limit_;  ///< a process that takes longer is ended
};

}  // namespace restenosis

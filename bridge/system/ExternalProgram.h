#pragma once

#include <atomic>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace restenosis {

/// A program that cannot be found.
struct ProgramMissing : std::runtime_error {
  explicit ProgramMissing(const std::string& programName);
  std::string program;
};

/// How a program ended.
struct ProgramExit {
  int status = 0;        ///< exit status; meaningless when a signal ended the program
  int signal = 0;        ///< the signal that ended it, 0 for none
  bool stopped = false;  ///< it was asked to end by ExternalProgram::stopWhen
  bool late = false;     ///< it was ended by ExternalProgram::stopAfter
  bool silent = false;   ///< it was ended by ExternalProgram::stopWhenSilentFor
  double seconds = 0.0;  ///< wall clock
  bool succeeded() const { return signal == 0 && status == 0; }
  /// The user or the system asked for the end (stopWhen, or SIGINT, SIGTERM, SIGHUP to the program itself),
  /// so trying again would be wrong.
  bool interrupted() const;
  /// "exit status 1", "signal 9 (Killed)".
  std::string describe() const;
};

/// Another program, run as a process without a shell. It dies with this program, and is killed and waited for
/// when an exception leaves `run`. It has a process group of its own, so that Ctrl-C reaches this program
/// alone, which then decides what becomes of the other: see stopWhen. A request to end that this program was
/// started to ignore (a script's `&`) is none that it ignores.
class ExternalProgram {
 public:
  /// Finds the program on the PATH, or where it says if its name has a slash. Throws ProgramMissing.
  explicit ExternalProgram(const std::string& program);

  /// Adds or replaces a variable of the program's environment, the rest of which is this program's; but for
  /// PWD, which is the folder that it runs in.
  ExternalProgram& setEnvironment(const std::string& variable, const std::string& value);

  /// Which of this program's variables the other does not have, by name, unless they are set.
  ExternalProgram& withoutEnvironment(std::function<bool(std::string_view variable)> left);

  /// Ends the program, with SIGTERM and later SIGKILL, once `requested` is true. Null: never.
  ExternalProgram& stopWhen(const std::atomic<bool>* requested);

  /// Ends it in the same way when it has run for so long.
  ExternalProgram& stopAfter(std::chrono::seconds limit);

  /// Ends it in the same way when its log has not grown for so long. Time in which this program was stopped
  /// itself does not count.
  ExternalProgram& stopWhenSilentFor(std::chrono::duration<double> limit);

  /// What it is sent when this program dies: SIGKILL where nothing else is said.
  ExternalProgram& signalledAtDeath(int signal);

  /// Runs it in `folder`, standard output and error going to `log` (replaced), standard input empty, and
  /// waits for its end. Throws std::runtime_error where it cannot be started.
  ProgramExit run(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
                  const std::filesystem::path& log) const;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  std::map<std::string, std::string> environment_;
  const std::atomic<bool>* stopRequested_ = nullptr;
  std::function<bool(std::string_view)> left_;
  std::optional<std::chrono::seconds> limit_;
  std::optional<std::chrono::duration<double>> silenceLimit_;
  int deathSignal_ = SIGKILL;
};

}  // namespace restenosis

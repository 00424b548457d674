#pragma once

#include <sys/types.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "tests/support/TemporaryFolder.h"

namespace restenosis {

/// How a process ended, and what it said.
struct ProcessEnd {
  int status = -1;  ///< exit status; -1 when a signal ended it
  int signal = 0;   ///< the signal that ended it, 0 for none
  bool timedOut = false;
  std::string out, err;
  double seconds = 0;
};

/// Everything a failed assertion should show of a process.
std::string toString(const ProcessEnd& end);

/// A program started as a user starts it, in a folder, with this process's environment and some changes to
/// it. Killed when it outlives this object.
class Process {
 public:
  using Environment = std::map<std::string, std::string>;

  Process(std::vector<std::string> command, const std::filesystem::path& folder,
          const Environment& environment = {});
  ~Process();
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  /// Sends a signal; nothing happens when the process has ended.
  void send(int signal);
  /// What it has written to standard error so far.
  std::string errorsSoFar() const;
  bool running();
  /// Waits for the end; kills it with SIGKILL when the limit passes.
  ProcessEnd wait(std::chrono::seconds limit);
  /// Seconds since the start.
  double age() const;

 private:
  TemporaryFolder logs_;
  std::chrono::steady_clock::time_point start_;
  pid_t pid_ = -1;
  int waitStatus_ = 0;
};

}  // namespace restenosis

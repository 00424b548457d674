#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <ostream>
#include <string>

namespace restenosis {

/// What the progress line shows of a step.
struct ProgressState {
  double time = 0;  ///< since deployment [s]
  std::uint64_t agents = 0, g0 = 0, g1 = 0, sg2m = 0;
  std::uint64_t divisions = 0;
  std::uint64_t flowSolves = 0;
  bool flowToCome = false;  ///< the flow is modelled and not solved yet: nobody knows what it will cost
};

/// Tells a user how far a run is: day, agents, counts by state, time left. On a terminal one line is kept up
/// to date; elsewhere (a file, a pipe) plain lines are written, not more often than every `plainInterval`.
/// What it is given to say is made printable: only its own commands reach the terminal.
class Progress {
 public:
  using Clock = std::chrono::steady_clock;

  /// `now` is for tests.
  Progress(std::ostream& out, bool terminal, double duration,
           std::function<Clock::time_point()> now = Clock::now);
  /// From now on every step, stage and what the flow does is a line of its own.
  void showEverything();
  /// Whether standard error is a terminal.
  static bool onTerminal();

  /// A stage before growth, for example ("deployment", 34, 100).
  void stage(const std::string& name, std::uint64_t done, std::uint64_t total);
  /// A step of growth. A step that is recorded is always shown, except when it follows another within a
  /// second.
  void step(const ProgressState& state, bool recorded);
  /// What the flow that is being solved does ("snappyHexMesh"), beside the day of the last step; on a
  /// terminal, or where everything is shown.
  void flow(const std::string& stage);
  /// Writes a line of its own, leaving the progress line intact.
  void message(const std::string& message);
  /// Ends the progress line; what is written next starts on a new one.
  void finish();

 private:
  void show(const std::string& line, bool force);
  std::string timeLeft(const ProgressState& state);
  std::string dayText() const;

  std::ostream& out_;
  bool terminal_;
  bool everything_ = false;
  double duration_;
  std::function<Clock::time_point()> now_;
  std::optional<Clock::time_point> shown_;
  struct Start {
    Clock::time_point wall;
    double time;
  };
  std::optional<Start> start_;  ///< of growth in this process: a resumed run starts late; of that with flow
  double time_ = 0;             ///< of the last step [s]
  std::string line_;            ///< on the terminal now
};

}  // namespace restenosis

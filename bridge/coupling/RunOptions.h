#pragma once

#include <atomic>
#include <stdexcept>
#include <string>
#include <utility>

namespace restenosis {

/// The user asked the run to stop.
struct Interrupted : std::runtime_error {
  explicit Interrupted(std::string where = {}) : std::runtime_error("interrupted"), saved(std::move(where)) {}
  std::string saved;  ///< where the state in the checkpoint stands ("day 3.00"); empty where there is none
};

/// What `Run::go` may be told beside the scene.
struct RunOptions {
  int threads = 1;
  int ranks = 1;  ///< processes of the flow solver
  const std::atomic<bool>* stopRequested =
      nullptr;  ///< set by a signal: save a checkpoint and throw Interrupted
  /// When resumed where the flow case that the next solve starts from is lost or changed: it starts from
  /// rest, on a new mesh, instead of being refused.
  bool flowFromRest = false;

  bool askedToStop() const { return stopRequested && *stopRequested; }
};

}  // namespace restenosis

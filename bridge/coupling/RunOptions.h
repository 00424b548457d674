#pragma once

#include <atomic>
#include <stdexcept>

namespace restenosis {

/// The user asked the run to stop; its state is in the checkpoint.
struct Interrupted : std::runtime_error {
  Interrupted() : std::runtime_error("interrupted; go on with --resume") {}
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

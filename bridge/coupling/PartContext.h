#pragma once

#include <atomic>

#include "bridge/coupling/RunState.h"

namespace restenosis {

/// What the parts of a run are made from: each takes of it what it names.
struct PartContext {
  RunState& run;
  int ranks = 1;  ///< processes of the flow solver
  const std::atomic<bool>* stopRequested = nullptr;
};

}  // namespace restenosis

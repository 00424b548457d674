#pragma once

#include <atomic>

#include "bridge/coupling/World.h"

namespace restenosis {

/// What the parts of a run are made from.
struct PartContext {
  World& world;
  int ranks = 1;  ///< processes of the flow solver
  const std::atomic<bool>* stopRequested = nullptr;
};

}  // namespace restenosis

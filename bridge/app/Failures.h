#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "bridge/coupling/RunOptions.h"
#include "bridge/output/Checkpoint.h"

namespace restenosis {

/// What a command adds to the reason of its end.
struct Advice {
  /// All there is to say when the user has ended it.
  std::function<std::string(const Interrupted&)> interrupted;
  std::string_view flowFailed = {};  ///< how to go on
  /// What sets the checkpoint's scene apart.
  std::function<std::string(const CheckpointRefused&)> foreignCheckpoint = {};
};

/// Does a command's work and returns its exit status. What ends it by an exception is told on standard error:
/// input that was refused is exit status 2, anything else 1.
int exitStatusOf(const std::function<int()>& work, const Advice& advice);

}  // namespace restenosis

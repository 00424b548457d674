#pragma once

#include <atomic>

namespace restenosis {

/// From now on the first Ctrl-C, SIGTERM or SIGHUP no longer ends the program, but sets the flag returned. A
/// SIGHUP that the program was started to ignore (nohup) stays ignored.
const std::atomic<bool>& stopOnSignals();

}  // namespace restenosis

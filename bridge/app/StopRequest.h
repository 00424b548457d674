#pragma once

#include <atomic>

namespace restenosis {

/// From now on the first Ctrl-C or SIGTERM no longer ends the program, but sets the flag returned.
const std::atomic<bool>& stopOnSignals();

}  // namespace restenosis

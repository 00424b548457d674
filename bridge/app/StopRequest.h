#pragma once

#include <atomic>

namespace restenosis {

/// From now on Ctrl-C and SIGTERM no longer end the program, but set the flag returned.
const std::atomic<bool>& stopOnSignals();

}  // namespace restenosis

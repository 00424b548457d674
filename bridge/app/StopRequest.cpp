#include "StopRequest.h"

#include <csignal>

namespace restenosis {
namespace {

std::atomic<bool> stopRequested{false};  // a signal's handler reaches nothing else

/// The first signal asks, a second one ends the program at once: the checkpoint is whole at every moment.
extern "C" void requestStop(int signal) {
  if (!stopRequested.exchange(true)) return;
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

}  // namespace

const std::atomic<bool>& stopOnSignals() {
  std::signal(SIGINT, requestStop);
  std::signal(SIGTERM, requestStop);
  return stopRequested;
}

}  // namespace restenosis

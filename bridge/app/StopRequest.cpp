#include "bridge/app/StopRequest.h"

#include <csignal>

namespace restenosis {
namespace {

std::atomic<bool> stopRequested{false};  // a signal's handler reaches nothing else

/// The first signal asks, a second one ends the program at once: the checkpoint is whole at every moment. A
/// terminal that closes may say so more than once.
extern "C" void requestStop(int signal) {
  if (!stopRequested.exchange(true) || signal == SIGHUP) return;
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

}  // namespace

const std::atomic<bool>& stopOnSignals() {
  std::signal(SIGINT, requestStop);
  std::signal(SIGTERM, requestStop);
  if (std::signal(SIGHUP, requestStop) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);  // started by nohup
  return stopRequested;
}

}  // namespace restenosis

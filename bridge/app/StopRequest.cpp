#include "StopRequest.h"

#include <csignal>

namespace restenosis {
namespace {

std::atomic<bool> stopRequested{false};  // a signal's handler reaches nothing else

extern "C" void requestStop(int) { stopRequested = true; }

}  // namespace

const std::atomic<bool>& stopOnSignals() {
  std::signal(SIGINT, requestStop);
  std::signal(SIGTERM, requestStop);
  return stopRequested;
}

}  // namespace restenosis

#include "ThreadWaiting.h"

#include <unistd.h>

#include <cstdlib>

namespace restenosis {
namespace {

// Some tenths of a millisecond: the pause between two loops of a relaxation.
constexpr const char* shortWait = "3000";

}  // namespace

void letWaitingThreadsSleep(char** argv) {
  if (std::getenv("OMP_WAIT_POLICY")) return;
  setenv("OMP_WAIT_POLICY", "passive", 1);
  setenv("GOMP_SPINCOUNT", shortWait, 0);
  execv("/proc/self/exe", argv);
  // Where that is not possible, the run is merely slower.
}

}  // namespace restenosis

#include "ThreadWaiting.h"

#include <unistd.h>

#include <cstdlib>

namespace restenosis {

void waitWithoutSpinning(char** argv) {
  if (std::getenv("OMP_WAIT_POLICY")) return;
  setenv("OMP_WAIT_POLICY", "passive", 1);
  execv("/proc/self/exe", argv);
  // Where that is not possible, the run is merely slower.
}

}  // namespace restenosis

#include "RuntimeSettings.h"

#include <unistd.h>

#include <cstdlib>
#include <string_view>

#if __has_include(<malloc.h>)
#include <malloc.h>
#endif

namespace restenosis {
namespace {

// Set between the two starts of the program, and to which of these.
constexpr const char* mark = "RESTENOSIS_STARTED_AGAIN";
constexpr const char *withTunables = "tunables", *withoutTunables = "no tunables";

// Some tenths of a millisecond: the pause between two loops of a relaxation.
constexpr const char* shortWait = "3000";

void setThreadWaiting() {
  if (std::getenv("OMP_WAIT_POLICY")) return;
  setenv("OMP_WAIT_POLICY", "passive", 1);
  setenv("GOMP_SPINCOUNT", shortWait, 0);
}

void startAgain(char** argv) {
  setThreadWaiting();
  const bool tune = std::getenv("GLIBC_TUNABLES") == nullptr;
  if (tune) setenv("GLIBC_TUNABLES", "glibc.malloc.hugetlb=1", 1);
  setenv(mark, tune ? withTunables : withoutTunables, 1);
  execv("/proc/self/exe", argv);
  // Where that is not possible, the run is merely slower.
}

}  // namespace

void applyRuntimeSettings(char** argv) {
  if (!std::getenv(mark)) startAgain(argv);
  const char* const marked = std::getenv(mark);
  if (marked && std::string_view(marked) == withTunables) unsetenv("GLIBC_TUNABLES");
  unsetenv(mark);
#if defined(M_MMAP_THRESHOLD) && defined(M_TRIM_THRESHOLD)
  mallopt(M_MMAP_THRESHOLD, 16 << 20);
  mallopt(M_TRIM_THRESHOLD, 64 << 20);
#endif
}

}  // namespace restenosis

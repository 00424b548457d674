#include "bridge/app/RuntimeSettings.h"

#include <sys/auxv.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
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
  // By its own name: started as /proc/self/exe it would be called `exe` in ps, top, pgrep and killall
  std::error_code error;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", error);
  if (!error) execv(program.c_str(), argv);
  // Where that is not possible, the run is merely slower.
}

/// Whether the loader was given this program as an argument: it is the loader then that would be started.
bool startedThroughTheLoader() { return getauxval(AT_BASE) == 0; }

}  // namespace

void applyRuntimeSettings(char** argv) {
  if (!std::getenv(mark) && !startedThroughTheLoader()) startAgain(argv);
  const char* const marked = std::getenv(mark);
  if (marked && std::string_view(marked) == withTunables) unsetenv("GLIBC_TUNABLES");
  unsetenv(mark);
#if defined(M_MMAP_THRESHOLD) && defined(M_TRIM_THRESHOLD)
  mallopt(M_MMAP_THRESHOLD, 16 << 20);
  mallopt(M_TRIM_THRESHOLD, 64 << 20);
#endif
}

}  // namespace restenosis

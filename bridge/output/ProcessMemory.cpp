#include "bridge/output/ProcessMemory.h"

#include <sys/resource.h>

#include <fstream>
#include <string>

namespace restenosis {

std::uint64_t peakMemory() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("VmHWM:")) return std::stoull(line.substr(6)) * 1024;
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
}

void resetPeakMemory() {
  // Writing 5 resets the peak resident set and nothing else (Linux, proc(5)).
  std::ofstream("/proc/self/clear_refs") << "5";
}

std::uint64_t peakChildMemory() {
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
}

}  // namespace restenosis

#include "bridge/app/StandardOutput.h"

#include <fmt/format.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <string>

#include "bridge/app/ExitStatus.h"

namespace restenosis {
namespace {

bool readerHasGone() {
  struct stat status {};
  if (fstat(STDOUT_FILENO, &status) != 0 || !(S_ISFIFO(status.st_mode) || S_ISSOCK(status.st_mode)))
    return false;
  pollfd end{.fd = STDOUT_FILENO, .events = POLLOUT, .revents = 0};
  return poll(&end, 1, 0) == 1 && (end.revents & (POLLERR | POLLHUP)) != 0;
}

/// Why standard output cannot be written: what its stream was told may be long forgotten, so it is asked for
/// an end of line more.
std::string obstacle() {
  if (write(STDOUT_FILENO, "\n", 1) == 1) return "part of it is missing";
  return std::strerror(errno);
}

}  // namespace

int statusWithOutput(int status) {
  std::cout.flush();
  const bool flushed = std::fflush(stdout) == 0;
  if ((flushed && std::cout) || readerHasGone()) return status;
  std::cerr << fmt::format("the output could not be written: {}\n", obstacle());
  return status == ExitStatus::done ? ExitStatus::failed : status;
}

}  // namespace restenosis

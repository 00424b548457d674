#include "bridge/app/ProcessSetup.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>

#if __has_include(<malloc.h>)
#include <malloc.h>
#endif

namespace restenosis {

void setUpProcess() {
  for (const int fd : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(fd, F_GETFD) >= 0 || errno != EBADF) continue;
    const int opened = open("/dev/null", O_RDONLY);  // the lowest that is free, which is this one
    static_cast<void>(opened);
  }
  sigset_t asking;
  sigemptyset(&asking);
  for (const int signal : {SIGINT, SIGTERM}) {
    std::signal(signal, SIG_DFL);
    sigaddset(&asking, signal);
  }
  sigprocmask(SIG_UNBLOCK, &asking, nullptr);
  for (const int failing : {SIGPIPE, SIGXFSZ}) std::signal(failing, SIG_IGN);
#if defined(M_MMAP_THRESHOLD) && defined(M_TRIM_THRESHOLD)
  mallopt(M_MMAP_THRESHOLD, 16 << 20);
  mallopt(M_TRIM_THRESHOLD, 64 << 20);
#endif
}

}  // namespace restenosis

#include "bridge/system/OwnProcess.h"

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <stdexcept>
#include <string_view>

namespace restenosis {
namespace {

constexpr unsigned longest = 60;  ///< [s]
/// The first byte of what the copy says.
constexpr char made = 'm', thrown = 't';

/// Whether all of it went into the pipe.
bool writeAll(int pipe, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(pipe, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

std::string readAll(int pipe) {
  std::string text;
  std::array<char, 1 << 16> part;
  for (;;) {
    const ssize_t count = ::read(pipe, part.data(), part.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return text;
    text.append(part.data(), static_cast<std::size_t>(count));
  }
}

/// The copy's whole life.
[[noreturn]] void makeInto(int pipe, const std::function<std::string()>& make) {
  // What this process does at signals is not for the copy
  for (const int signal : {SIGALRM, SIGABRT, SIGINT, SIGTERM}) std::signal(signal, SIG_DFL);
  ::alarm(longest);
  std::string said;
  try {
    said = made + make();
  } catch (const std::exception& error) {
    said = thrown + std::string(error.what());
  }
  ::_exit(writeAll(pipe, said) ? 0 : 1);
}

}  // namespace

std::string inOwnProcess(const std::function<std::string()>& make) {
  std::array<int, 2> ends{};
  if (::pipe(ends.data()) != 0) throw std::runtime_error(fmt::format("no pipe: {}", std::strerror(errno)));
  const pid_t copy = ::fork();
  if (copy == 0) {
    ::close(ends[0]);
    makeInto(ends[1], make);
  }
  ::close(ends[1]);
  std::string said = copy > 0 ? readAll(ends[0]) : "";
  ::close(ends[0]);
  int status = 0;
  if (copy < 0) throw std::runtime_error(fmt::format("no process: {}", std::strerror(errno)));
  while (::waitpid(copy, &status, 0) < 0 && errno == EINTR) continue;
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM)
    throw std::runtime_error(fmt::format("it took longer than {} s", longest));
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0 || said.empty())
    throw std::runtime_error("what reads such files crashed on it; is it damaged?");
  const bool returned = said.front() == made;
  said.erase(0, 1);
  if (!returned) throw std::runtime_error(said);
  return said;
}

}  // namespace restenosis

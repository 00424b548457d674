#include "Figures.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <thread>

namespace restenosis {

namespace fs = std::filesystem;

namespace {

std::string chosenInterpreter() {
  const char* chosen = std::getenv("RESTENOSIS_PYTHON");
  return chosen != nullptr && *chosen != '\0' ? chosen : "/usr/bin/python3";
}

/// Ends a process with all it started.
void killGroup(pid_t process) {
  ::kill(-process, SIGKILL);
  ::waitpid(process, nullptr, 0);
}

/// The last line of a log that is not empty: where a Python program says what went wrong.
std::string lastLine(const fs::path& log) {
  std::ifstream stream(log);
  std::string last;
  for (std::string line; std::getline(stream, line);)
    if (!line.empty()) last = line;
  return last;
}

}  // namespace

Figures::Figures() : Figures(chosenInterpreter(), RESTENOSIS_FIGURES, std::chrono::seconds(300)) {}

Figures::Figures(std::string interpreter, fs::path script, std::chrono::seconds limit)
    : interpreter_(std::move(interpreter)), script_(std::move(script)), limit_(limit) {}

std::string Figures::draw(const fs::path& results) const {
  const fs::path log = results / "figures.log";
  const std::string script = script_.string(), folder = results.string();
  // -B: no compiled files beside the script, which lies in the user's source tree.
  std::array<char*, 5> arguments{const_cast<char*>(interpreter_.c_str()), const_cast<char*>("-B"),
                                 const_cast<char*>(script.c_str()), const_cast<char*>(folder.c_str()),
                                 nullptr};
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
  posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  pid_t process = 0;
  const int error =
      posix_spawnp(&process, interpreter_.c_str(), &actions, &attributes, arguments.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) {
    return fmt::format(
        "no pictures: cannot run {}: {} (install python3, or name another with RESTENOSIS_PYTHON)",
        interpreter_, std::strerror(error));
  }

  const auto deadline = std::chrono::steady_clock::now() + limit_;
  int status = 0;
  while (::waitpid(process, &status, WNOHANG) == 0) {
    if (std::chrono::steady_clock::now() > deadline) {
      killGroup(process);
      return fmt::format("pictures were given up after {} s; see {}", limit_.count(), log.string());
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return "";
  return fmt::format("not all pictures were drawn: {} (see {})", lastLine(log), log.string());
}

}  // namespace restenosis

#include "tests/support/Process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <thread>

namespace restenosis {

using namespace std::chrono_literals;

std::string toString(const ProcessEnd& end) {
  return fmt::format("exit status {}, signal {}{}, {:.1f} s\n--- out\n{}\n--- err\n{}", end.status,
                     end.signal, end.timedOut ? " (out of time)" : "", end.seconds, end.out, end.err);
}

Process::Process(std::vector<std::string> command, const std::filesystem::path& folder,
                 const Environment& environment)
    : start_(std::chrono::steady_clock::now()) {
  std::vector<std::string> variables;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string text = *entry;
    if (!environment.contains(text.substr(0, text.find('=')))) variables.push_back(text);
  }
  for (const auto& [name, value] : environment) variables.push_back(name + "=" + value);
  const auto pointers = [](std::vector<std::string>& texts) {
    std::vector<char*> list;
    for (auto& text : texts) list.push_back(text.data());
    list.push_back(nullptr);
    return list;
  };
  const auto arguments = pointers(command), variablePointers = pointers(variables);
  const std::string out = logs_ / "out", err = logs_ / "err";
  pid_ = ::fork();
  if (pid_ != 0) return;
  // A group of its own: the terminal's Ctrl-C of whoever runs the tests must not be mistaken for the test's.
  ::setpgid(0, 0);
  const int input = ::open("/dev/null", O_RDONLY);
  const int output = ::open(out.c_str(), O_WRONLY | O_CREAT, 0644);
  const int errors = ::open(err.c_str(), O_WRONLY | O_CREAT, 0644);
  if (::dup2(input, 0) < 0 || ::dup2(output, 1) < 0 || ::dup2(errors, 2) < 0 || ::chdir(folder.c_str()) != 0)
    ::_exit(126);
  ::execve(arguments[0], arguments.data(), variablePointers.data());
  ::_exit(127);
}

Process::~Process() {
  if (!running()) return;
  send(SIGKILL);
  ::waitpid(pid_, &waitStatus_, 0);
}

void Process::send(int signal) {
  if (pid_ > 0) ::kill(pid_, signal);
}

std::string Process::errorsSoFar() const { return readText(logs_ / "err"); }

bool Process::running() {
  if (pid_ > 0 && ::waitpid(pid_, &waitStatus_, WNOHANG) == pid_) pid_ = -1;
  return pid_ > 0;
}

ProcessEnd Process::wait(std::chrono::seconds limit) {
  ProcessEnd end;
  while (running()) {
    if (age() > static_cast<double>(limit.count()) && !end.timedOut) {
      end.timedOut = true;
      send(SIGKILL);
    }
    std::this_thread::sleep_for(5ms);
  }
  end.seconds = age();
  if (WIFSIGNALED(waitStatus_)) end.signal = WTERMSIG(waitStatus_);
  if (WIFEXITED(waitStatus_)) end.status = WEXITSTATUS(waitStatus_);
  end.out = readText(logs_ / "out");
  end.err = readText(logs_ / "err");
  return end;
}

double Process::age() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

}  // namespace restenosis

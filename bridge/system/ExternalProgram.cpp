#include "bridge/system/ExternalProgram.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <thread>

namespace restenosis {
namespace {

using Clock = std::chrono::steady_clock;

/// How often a request to stop is looked for, and how long a program has to end by itself after one. MPI's
/// starter gives its processes a second before it kills them (assumed: ample).
constexpr std::chrono::milliseconds stopLatency{5};
constexpr std::chrono::seconds gracePeriod{5};

bool namesItsPlace(const std::string& program) { return program.find('/') != std::string::npos; }

bool canBeStarted(const std::filesystem::path& file) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(file, ignored) && access(file.c_str(), X_OK) == 0;
}

std::filesystem::path find(const std::string& program) {
  if (namesItsPlace(program)) {
    if (canBeStarted(program)) return std::filesystem::absolute(program);
    throw ProgramMissing(program);
  }
  const char* variable = std::getenv("PATH");
  std::istringstream folders(variable ? variable : "");
  for (std::string folder; std::getline(folders, folder, ':');) {
    const auto candidate = std::filesystem::path(folder.empty() ? "." : folder) / program;
    if (canBeStarted(candidate)) return std::filesystem::absolute(candidate);
  }
  throw ProgramMissing(program);
}

/// A file descriptor that closes itself.
class Descriptor {
 public:
  explicit Descriptor(int fd = -1) : fd_(fd) {}
  ~Descriptor() { close(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int get() const { return fd_; }
  void close() {
    if (fd_ >= 0) ::close(fd_);
    fd_ = -1;
  }

 private:
  int fd_;
};

/// A child process that leads a process group; killed and waited for unless `wait` has returned.
class Child {
 public:
  explicit Child(pid_t pid) : pid_(pid) {}
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child() {
    if (pid_ <= 0) return;
    signal(SIGKILL);
    int status = 0;
    while (waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
    }
  }
  int wait() {
    while (!ended(0)) {
    }
    return status_;
  }
  /// The same, ending the child once enough() is true; says whether it had to.
  template <class Enough>
  bool waitOrStop(Enough&& enough) {
    for (;; std::this_thread::sleep_for(stopLatency)) {
      if (ended(WNOHANG)) return false;
      if (enough()) break;
    }
    signal(SIGTERM);
    for (const auto last = Clock::now() + gracePeriod; Clock::now() < last;) {
      if (ended(WNOHANG)) return true;
      std::this_thread::sleep_for(stopLatency);
    }
    signal(SIGKILL);
    wait();
    return true;
  }
  int status() const { return status_; }

 private:
  bool ended(int options) {
    const pid_t got = waitpid(pid_, &status_, options);
    if (got < 0 && errno != EINTR)
      throw std::runtime_error(fmt::format("waiting for a program: {}", std::strerror(errno)));
    if (got <= 0) return false;
    pid_ = -1;
    return true;
  }
  /// To the whole group; to the child alone where it has not made its group yet.
  void signal(int number) const {
    if (kill(-pid_, number) != 0) kill(pid_, number);
  }

  pid_t pid_;
  int status_ = 0;
};

std::vector<char*> pointers(const std::vector<std::string>& strings) {
  std::vector<char*> result;
  for (const auto& s : strings) result.push_back(const_cast<char*>(s.c_str()));
  result.push_back(nullptr);
  return result;
}

std::vector<std::string> mergedEnvironment(const std::map<std::string, std::string>& changes,
                                           const std::function<bool(std::string_view)>& left) {
  std::vector<std::string> result;
  for (char** entry = environ; *entry; ++entry) {
    const std::string text = *entry;
    const std::string variable = text.substr(0, text.find('='));
    if (!changes.contains(variable) && !(left && left(variable))) result.push_back(text);
  }
  for (const auto& [key, value] : changes) result.push_back(key + "=" + value);
  return result;
}

/// For how long a file has not grown.
class Silence {
 public:
  explicit Silence(int fd) : fd_(fd) {}
  std::chrono::duration<double> untilNow() {
    const auto now = Clock::now();
    struct stat status {};
    fstat(fd_, &status);
    if (status.st_size != size_)
      lasted_ = {};
    else
      lasted_ += std::min<Clock::duration>(now - last_, longestGlance);
    size_ = status.st_size, last_ = now;
    return lasted_;
  }

 private:
  /// A longer time between two glances is one in which this program was stopped, and maybe the other too.
  static constexpr std::chrono::seconds longestGlance{1};

  int fd_;
  off_t size_ = 0;
  Clock::time_point last_ = Clock::now();
  Clock::duration lasted_{};
};

/// What the new process does before it becomes the program; only async-signal-safe calls, since other threads
/// of this program may hold locks. On failure the errno goes to `report`.
[[noreturn]] void becomeProgram(const char* program, char* const* arguments, char* const* environment,
                                const char* folder, int input, int output, int report, pid_t parent,
                                int deathSignal) {
  const auto fail = [report] {
    const int error = errno;
    [[maybe_unused]] const auto written = write(report, &error, sizeof error);
    _exit(127);
  };
  if (prctl(PR_SET_PDEATHSIG, deathSignal) != 0) fail();
  if (getppid() != parent) _exit(127);  // the parent died before the line above
  if (setpgid(0, 0) != 0) fail();
  for (const int ending : {SIGINT, SIGTERM, SIGPIPE}) signal(ending, SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  if (chdir(folder) != 0) fail();
  if (dup2(input, STDIN_FILENO) < 0 || dup2(output, STDOUT_FILENO) < 0 || dup2(output, STDERR_FILENO) < 0)
    fail();
  execve(program, arguments, environment);
  fail();
  _exit(127);
}

}  // namespace

ProgramMissing::ProgramMissing(const std::string& programName)
    : std::runtime_error(namesItsPlace(programName)
                             ? fmt::format("there is no program {}", programName)
                             : fmt::format("the program '{}' is not on the PATH", programName)),
      program(programName) {}

bool ProgramExit::interrupted() const {
  if (late || silent) return stopped;  // the signal was ours
  return stopped || signal == SIGINT || signal == SIGTERM || signal == SIGHUP;
}

std::string ProgramExit::describe() const {
  return signal ? fmt::format("signal {} ({})", signal, strsignal(signal))
                : fmt::format("exit status {}", status);
}

ExternalProgram::ExternalProgram(const std::string& program) : path_(find(program)) {}

ExternalProgram& ExternalProgram::setEnvironment(const std::string& variable, const std::string& value) {
  environment_[variable] = value;
  return *this;
}

ExternalProgram& ExternalProgram::withoutEnvironment(std::function<bool(std::string_view)> left) {
  left_ = std::move(left);
  return *this;
}

ExternalProgram& ExternalProgram::stopWhen(const std::atomic<bool>* requested) {
  stopRequested_ = requested;
  return *this;
}

ExternalProgram& ExternalProgram::stopAfter(std::chrono::seconds limit) {
  limit_ = limit;
  return *this;
}

ExternalProgram& ExternalProgram::stopWhenSilentFor(std::chrono::duration<double> limit) {
  silenceLimit_ = limit;
  return *this;
}

ExternalProgram& ExternalProgram::signalledAtDeath(int signal) {
  deathSignal_ = signal;
  return *this;
}

ProgramExit ExternalProgram::run(const std::vector<std::string>& arguments,
                                 const std::filesystem::path& folder,
                                 const std::filesystem::path& log) const {
  const auto start = Clock::now();
  const Descriptor input(open("/dev/null", O_RDONLY | O_CLOEXEC));
  const Descriptor output(open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644));
  if (output.get() < 0)
    throw std::runtime_error(fmt::format("cannot write {}: {}", log.string(), std::strerror(errno)));
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error(fmt::format("pipe: {}", std::strerror(errno)));
  const Descriptor reportIn(ends[0]);
  Descriptor reportOut(ends[1]);

  std::vector<std::string> words = {path_.string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  const auto argv = pointers(words);
  auto changes = environment_;
  std::error_code absent;  // told by the attempt to start there
  changes.try_emplace("PWD", std::filesystem::canonical(folder, absent).string());
  const auto environment = mergedEnvironment(changes, left_);
  const auto envp = pointers(environment);
  const pid_t parent = getpid();
  const pid_t pid = fork();
  if (pid < 0)
    throw std::runtime_error(fmt::format("cannot start {}: {}", path_.string(), std::strerror(errno)));
  if (pid == 0)
    becomeProgram(path_.c_str(), argv.data(), envp.data(), folder.c_str(), input.get(), output.get(),
                  reportOut.get(), parent, deathSignal_);
  Child child(pid);
  reportOut.close();

  // The pipe closes without a word when the program has been started
  int error = 0;
  ssize_t got;
  while ((got = read(reportIn.get(), &error, sizeof error)) < 0 && errno == EINTR) {
  }
  if (got > 0)
    throw std::runtime_error(
        fmt::format("cannot start {} in {}: {}", path_.string(), folder.string(), std::strerror(error)));

  ProgramExit result;
  const auto isAsked = [this] { return stopRequested_ != nullptr && *stopRequested_; };
  const auto isLate = [&] { return limit_ && Clock::now() - start > *limit_; };
  Silence silence(output.get());
  const auto isSilent = [&] { return silenceLimit_ && silence.untilNow() > *silenceLimit_; };
  if (!stopRequested_ && !limit_ && !silenceLimit_) {
    child.wait();
  } else if (child.waitOrStop([&] {
               result.stopped = isAsked();
               result.late = !result.stopped && isLate();
               result.silent = !result.stopped && !result.late && isSilent();
               return result.stopped || result.late || result.silent;
             })) {
    result.stopped = result.stopped || isAsked();
  }
  const int status = child.status();
  result.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  if (WIFSIGNALED(status))
    result.signal = WTERMSIG(status);
  else
    result.status = WEXITSTATUS(status);
  return result;
}

}  // namespace restenosis

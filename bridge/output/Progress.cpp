#include "bridge/output/Progress.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <ctime>

#include "bridge/output/DurationText.h"
#include "tissue/parameters/Printable.h"
#include "tissue/parameters/SecondsPerDay.h"

namespace restenosis {

namespace {

using namespace std::chrono_literals;

constexpr auto terminalInterval = 100ms;
constexpr auto plainInterval = 5s;
constexpr auto recordedInterval = 1s;

std::size_t terminalWidth() {
  winsize size{};
  return ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 100;
}

/// The time of day in so many seconds, where that is not at once.
std::string clockText(double seconds) {
  if (seconds < 300) return "";
  return fmt::format(", done about {:%H:%M}", fmt::localtime(std::time(nullptr) + std::lround(seconds)));
}

}  // namespace

Progress::Progress(std::ostream& out, bool terminal, double duration, std::function<Clock::time_point()> now)
    : out_(out), terminal_(terminal), duration_(duration), now_(std::move(now)) {}

void Progress::showEverything() {
  terminal_ = false;
  everything_ = true;
}

bool Progress::onTerminal() { return ::isatty(STDERR_FILENO) == 1; }

void Progress::stage(const std::string& name, std::uint64_t done, std::uint64_t total) {
  show(fmt::format("{} {}/{}", name, done, total), done == 0 || done == total);
}

void Progress::step(const ProgressState& s, bool recorded) {
  const auto left = timeLeft(s);
  time_ = s.time;
  const bool due = recorded && (!shown_ || now_() - *shown_ >= recordedInterval);
  show(fmt::format("{}  {} agents  G0 {}  G1 {}  S/G2/M {}  divisions {}  flow solves {}{}", dayText(),
                   s.agents, s.g0, s.g1, s.sg2m, s.divisions, s.flowSolves, left),
       due || s.time >= duration_);
}

void Progress::flow(const std::string& stage) {
  if (terminal_ || everything_) show(fmt::format("{}  flow: {} ...", dayText(), stage), true);
}

std::string Progress::dayText() const {
  return fmt::format("day {:5.2f}/{:.4g}", time_ / secondsPerDay, duration_ / secondsPerDay);
}

std::string Progress::timeLeft(const ProgressState& state) {
  if (state.flowToCome) return "";
  if (!start_) start_ = {now_(), state.time};
  const double advanced = state.time - start_->time;
  if (advanced <= 0 || state.time >= duration_) return "";
  const double elapsed = std::chrono::duration<double>(now_() - start_->wall).count();
  const double left = elapsed * (duration_ - state.time) / advanced;
  return fmt::format("  {} left{}", durationText(left), clockText(left));
}

void Progress::show(const std::string& line, bool force) {
  const auto now = now_();
  const Clock::duration interval =
      terminal_ ? Clock::duration(terminalInterval) : Clock::duration(plainInterval);
  if (!force && !everything_ && shown_ && now - *shown_ < interval) return;
  shown_ = now;
  if (terminal_) {
    line_ = printable(line).substr(0, std::max<std::size_t>(terminalWidth(), 2) - 1);
    out_ << '\r' << line_ << "\x1b[K" << std::flush;
  } else {
    out_ << printable(line) << std::endl;
  }
}

void Progress::message(const std::string& message) {
  const std::string text = printable(message, true);
  if (line_.empty()) {
    out_ << text << std::endl;
  } else {
    out_ << '\r' << text << "\x1b[K\n" << line_ << std::flush;
  }
}

void Progress::finish() {
  if (!line_.empty()) out_ << std::endl;
  line_.clear();
}

}  // namespace restenosis

#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace restenosis {

/// What one part of the program has cost.
struct PartCost {
  double seconds = 0;                 ///< wall clock, without the parts measured inside it
  std::uint64_t peakMemory = 0;       ///< largest resident set of this process in it [bytes]
  std::uint64_t peakChildMemory = 0;  ///< largest resident set of a child process ended in it [bytes], a
                                      ///< lower bound: seen only where it exceeds that of every earlier child
  std::uint64_t calls = 0;

  template <class Archive>
  void archive(Archive& a) {
    a(seconds, peakMemory, peakChildMemory, calls);
  }
};

/// Wall seconds and peak memory by named part (deploy, relax, biology, surface, mesh, flow, output). Parts
/// may nest: the time of the inner one is not counted in the outer one, so the parts add up. The costs are
/// part of a checkpoint and go on adding up after a resume. For use by one thread.
class PartTimer {
 public:
  /// Measures from its construction to its destruction.
  class Measurement {
   public:
    Measurement(PartTimer& timer, std::string part) : timer_(timer) { timer_.enter(std::move(part)); }
    ~Measurement() { timer_.leave(); }
    Measurement(const Measurement&) = delete;
    Measurement& operator=(const Measurement&) = delete;

   private:
    PartTimer& timer_;
  };

  [[nodiscard]] Measurement measure(std::string part) { return {*this, std::move(part)}; }
  /// Books seconds measured as one part to another: a flow backend tells afterwards how long it meshed. Peak
  /// memory is not told apart: the other part has that of this one.
  void transfer(const std::string& from, const std::string& to, double seconds);

  const std::map<std::string, PartCost>& costs() const { return costs_; }
  /// Of all parts, including earlier sessions of a resumed run [s].
  double totalSeconds() const;

  template <class Archive>
  void archive(Archive& a) {
    a(costs_);
  }

 private:
  using Clock = std::chrono::steady_clock;

  void enter(std::string part);
  void leave();
  /// Books the time since the last event, and the peak memory, to the innermost open part.
  void book();

  std::map<std::string, PartCost> costs_;
  std::vector<std::string> open_;
  Clock::time_point since_;
  std::uint64_t childPeak_ = 0;
};

}  // namespace restenosis

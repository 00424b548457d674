#include "bridge/output/PartTimer.h"

#include <algorithm>
#include <numeric>

#include "bridge/output/ProcessMemory.h"

namespace restenosis {

void PartTimer::book() {
  const auto now = Clock::now();
  if (!open_.empty()) {
    auto& cost = costs_[open_.back()];
    cost.seconds += std::chrono::duration<double>(now - since_).count();
    cost.peakMemory = std::max(cost.peakMemory, peakMemory());
    if (const auto children = peakChildMemory(); children > childPeak_) {
      cost.peakChildMemory = std::max(cost.peakChildMemory, children);
      childPeak_ = children;
    }
  }
  resetPeakMemory();
  since_ = Clock::now();
}

void PartTimer::enter(std::string part) {
  book();
  ++costs_[part].calls;
  open_.push_back(std::move(part));
}

void PartTimer::leave() {
  book();
  open_.pop_back();
}

void PartTimer::transfer(const std::string& from, const std::string& to, double seconds) {
  book();  // what is measured right now counts, too
  auto& source = costs_[from];
  auto& target = costs_[to];
  source.seconds -= seconds;
  target.seconds += seconds;
  target.peakMemory = std::max(target.peakMemory, source.peakMemory);
  target.peakChildMemory = std::max(target.peakChildMemory, source.peakChildMemory);
  ++target.calls;
}

double PartTimer::totalSeconds() const {
  return std::accumulate(costs_.begin(), costs_.end(), 0.0,
                         [](double sum, const auto& part) { return sum + part.second.seconds; });
}

}  // namespace restenosis

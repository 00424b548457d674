#include "bridge/coupling/Schedule.h"

#include <algorithm>
#include <numeric>
#include <optional>

namespace restenosis {

std::uint64_t PartCount::skippedInAll() const {
  return std::accumulate(skipped.begin(), skipped.end(), std::uint64_t{0},
                         [](std::uint64_t sum, const auto& entry) { return sum + entry.second; });
}

void Schedule::add(std::unique_ptr<Part> part) {
  counts_.try_emplace(std::string(part->name()));
  parts_.push_back(std::move(part));
}

void Schedule::advance(const Instant& now, const std::function<void()>& beforeLong) {
  for (; next_ < parts_.size(); ++next_) {
    Part& part = *parts_[next_];
    if (!part.appliesAt(now)) continue;
    const Verdict verdict = decide(next_, now);
    PartCount& count = counts_[std::string(part.name())];
    if (verdict.yes) {
      if (beforeLong && part.takesLong()) beforeLong();
      part.run(now);
      part.noteInputs();
      ++count.done;
    } else {
      ++count.skipped[verdict.reason];
    }
  }
  next_ = 0;
}

Verdict Schedule::decide(std::size_t part, const Instant& now) const {
  if (mode_ == ScheduleMode::everyStep) return Verdict::run();
  if (Verdict verdict = needed(part, now); !verdict.yes) return verdict;
  return parts_[part]->inputsChanged(now);
}

Verdict Schedule::needed(std::size_t part, const Instant& now) const {
  if (parts_[part]->isPurpose(now)) return Verdict::run();
  std::optional<Verdict> refusal;
  for (const Quantity quantity : parts_[part]->writes()) {
    for (std::size_t reader = 0; reader < parts_.size(); ++reader) {
      const auto& reads = parts_[reader]->reads();
      if (reader == part || std::ranges::find(reads, quantity) == reads.end()) continue;
      Verdict answer = parts_[reader]->needs(quantity, now);
      // A reader further down must itself be needed; one further up reads the quantity in the next step.
      if (answer.yes && reader > part) answer = needed(reader, now);
      if (answer.yes) return answer;
      if (!refusal) refusal = answer;
    }
  }
  return refusal.value_or(Verdict::skip("nothing reads what it makes"));
}

}  // namespace restenosis

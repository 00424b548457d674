#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "bridge/coupling/Part.h"
#include "bridge/scene/RunParameters.h"

namespace restenosis {

/// How often a part ran, and how often and why it did not.
struct PartCount {
  std::uint64_t done = 0;
  std::map<std::string, std::uint64_t> skipped;

  std::uint64_t skippedInAll() const;
  template <class Archive>
  void archive(Archive& a) {
    a(done, skipped);
  }
};

/// Runs the parts of the loop, in order, each only when it must: when a part that reads what it writes can
/// change a result by it, and when its own inputs have changed by more than its tolerance. A part nobody
/// reads runs for its own sake. With `everyStep`, every part runs in every step: the reference (T6).
class Schedule {
 public:
  explicit Schedule(ScheduleMode mode) : mode_(mode) {}

  /// Appends a part. Readers come after the writers they read within a step.
  void add(std::unique_ptr<Part> part);
  /// Makes one step, or the rest of one: a state that was saved by `beforeLong`, which is called before a
  /// part that takes long, goes on with that part.
  void advance(const Instant& now, const std::function<void()>& beforeLong = {});

  /// Whether `part` would run now, without running it.
  Verdict decide(std::size_t part, const Instant& now) const;

  const std::map<std::string, PartCount>& counts() const { return counts_; }
  /// The part of this type, or null.
  template <class MyPart>
  MyPart* find() const {
    for (const auto& part : parts_)
      if (auto* found = dynamic_cast<MyPart*>(part.get())) return found;
    return nullptr;
  }

  template <class Archive>
  void archive(Archive& a) {
    a(counts_, next_);
    for (const auto& part : parts_) a(*part);
  }

 private:
  Verdict needed(std::size_t part, const Instant& now) const;

  ScheduleMode mode_;
  std::vector<std::unique_ptr<Part>> parts_;
  std::map<std::string, PartCount> counts_;
  std::uint64_t next_ = 0;  ///< the part that the step goes on with
};

}  // namespace restenosis

#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bridge/coupling/Instant.h"
#include "bridge/coupling/Quantities.h"

namespace restenosis {

/// An answer to "must this run?", with the reason that is counted and shown when it is no. Reasons are
/// categories: few different texts, without numbers.
struct Verdict {
  bool yes = true;
  std::string reason;

  static Verdict run() { return {}; }
  static Verdict skip(std::string reason) { return {false, std::move(reason)}; }
  /// No where there is a reason.
  static Verdict unless(std::string_view reason) { return {reason.empty(), std::string(reason)}; }
};

/// A part of the coupled loop. It declares what it reads and writes, and says what would change its answer;
/// when it runs is the schedule's decision (model 9).
///
/// A part reaches quantities by what it declares only: `read`, `write` and `observe` give it the access. What
/// lives in the agents is given as the agents, or as the wall that holds them.
class Part {
 public:
  explicit Part(Quantities& quantities) : quantities_(quantities) {}
  virtual ~Part() = default;
  Part(const Part&) = delete;
  Part& operator=(const Part&) = delete;

  virtual std::string_view name() const = 0;
  const std::vector<Quantity>& reads() const { return reads_; }
  const std::vector<Quantity>& writes() const { return writes_; }

  /// Whether this part is what a run is made for at this instant, so that it needs no reader to run.
  virtual bool isPurpose(const Instant& now) const;

  /// Whether there is anything for this part to do at such an instant at all, whatever the schedule.
  virtual bool appliesAt(const Instant& now) const;

  /// Whether what this part makes of `quantity`, one of its reads, can change any result now. The parts that
  /// write the quantity do not run while no reader needs it.
  virtual Verdict needs(Quantity quantity, const Instant& now) const;

  /// Whether the inputs have changed by more than the part's tolerance since it last ran.
  virtual Verdict inputsChanged(const Instant& now) const;

  virtual void run(const Instant& now) = 0;

  /// Whether running may take so long that the state before it is worth saving.
  virtual bool takesLong() const { return false; }

  /// Whether anything it reads has been written since it last ran.
  bool hasNewInput() const;
  /// It has run: what it reads is known to it.
  void noteInputs();

  template <class Archive>
  void archive(Archive& a) {
    a(seen_);
  }

 protected:
  template <Quantity q>
  Read<q> read() {
    reads_.push_back(q);
    return Read<q>(quantities_);
  }
  template <Quantity q>
  Write<q> write() {
    writes_.push_back(q);
    return Write<q>(quantities_);
  }
  /// Looks at a quantity as it happens to be: neither a reason to make it nor news when it changes.
  template <Quantity q>
  Read<q> observe() {
    return Read<q>(quantities_);
  }

 private:
  Quantities& quantities_;
  std::vector<Quantity> reads_, writes_;
  /// One more than the number of changes of each quantity when it was last read; 0 for never.
  std::array<std::uint64_t, quantityCount> seen_{};
};

}  // namespace restenosis

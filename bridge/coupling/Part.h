#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bridge/coupling/Instant.h"

namespace restenosis {

/// What the parts of the loop hand to each other.
enum class Quantity : std::uint8_t {
  cellStates,       ///< cycle states, sizes and number of cells
  agentPositions,   ///< where agents are
  exposure,         ///< which cells face the lumen, which are crowded
  coverage,         ///< which cells carry endothelium
  lumen,            ///< shape of the lumen
  wallTraction,     ///< on the faces of the flow's wall
  wallShearStress,  ///< on cells
  nitricOxide,      ///< of cells
  record            ///< what is written for the user
};

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

/// A part of the coupled loop. It says what it reads and writes and what would change its answer; when it
/// runs is the schedule's decision (model 9).
class Part {
 public:
  virtual ~Part() = default;
  virtual std::string_view name() const = 0;
  virtual std::vector<Quantity> reads() const = 0;
  virtual std::vector<Quantity> writes() const = 0;

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
};

}  // namespace restenosis

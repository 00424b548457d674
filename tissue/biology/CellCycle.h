#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "tissue/agents/AgentStore.h"
#include "tissue/biology/Activation.h"
#include "tissue/biology/ArrestRules.h"
#include "tissue/biology/CellCycleParameters.h"

namespace restenosis {

/// What a step of the cycle did, in cells.
struct CycleReport {
  Index enteredG1 = 0;    ///< left rest
  Index arrested = 0;     ///< sent back to rest from G1
  Index enteredSg2m = 0;  ///< finished growing
  Index divisions = 0;
  bool anyGrew = false;  ///< whether any radius changed
};

/// The cell cycle of the free SMC (model 5): G0 -> G1 (growth) -> S/G2/M -> division.
///
/// At the checkpoint G0 -> G1 and in G1 a cell rests while a rule arrests it (ArrestRules); a cell sent back
/// to G0 keeps its radius and length of G1, and its clock restarts. From S on no rule applies. In G1 the
/// radius grows as r <- r 2^(dt / (3 T)), T the cell's length of G1, up to twice the volume at birth, and is
/// exactly that at its end. Agents flagged `fixed` hold the ends of the vessel and do not cycle.
///
/// Recruitment: injury does not activate all cells in the same hour. A cell that never divided may leave G0
/// only after a random time within `recruitment`; without it (0, the model as published) all go through their
/// first cycle together, and the tissue grows in steps until the spread of G1 has desynchronised them.
/// Where activation is modelled, a cell leaves G0 when it says (Activation::entry) and recruitment is over.
///
/// A cell with matrix around it grows and divides as one without: all radii above are of the cell alone.
///
/// Phases need not be multiples of the step: the rest of a step after a phase goes to the next phase, after a
/// division to mother and daughter. They keep it on their clocks in G0 until the checkpoint lets them pass; a
/// checkpoint that arrests them clears it. A cell divides at most once a step; a cycle shorter than the step
/// therefore runs once a step, and the rest is never more than one step. A phase that lacks less than 1e-9 of
/// its length and of a step has ended: that is rounding.
class CellCycle {
 public:
  /// `step` [s] is the biological step; `activation` empty where it is not modelled.
  CellCycle(const CellCycleParameters& parameters, std::uint64_t seed, double step,
            const std::optional<Activation>& activation = {});

  /// Advances every cell by the step that begins at `time` [s] after deployment. By default recruitment is
  /// over; activation needs the time. Returns the cells that are to divide, in ascending order of their ids,
  /// with the rest of the step on their clocks; the caller divides them (Division).
  std::vector<Index> advance(AgentStore& agents, const ArrestRules& rules, CycleReport& report,
                             double time = std::numeric_limits<double>::infinity()) const;

  /// Whether the agent goes through the cycle: a smooth muscle cell that is free to move.
  static bool cycles(const AgentStore& agents, Index i) {
    return agents.kind[i] == AgentKind::smc && !agents.has(i, fixed);
  }
  /// Whether it does and is before S, where rules apply.
  static bool obeysRules(const AgentStore& agents, Index i) {
    return cycles(agents, i) && agents.state[i] != CycleState::sg2m;
  }

  /// Length of G1 [s]: normal, truncated at three standard deviations and at zero, drawn by (seed, id,
  /// generation).
  double drawG1Duration(AgentId id, std::uint32_t generation) const;

  /// When a cell that never divided may first leave rest [s after deployment]: uniform over the time of
  /// recruitment, drawn by (seed, id).
  double drawRecruitment(AgentId id) const;

 private:
  enum class Passage : std::uint8_t { enteredG1 = 1, arrested = 2, enteredSg2m = 4, divides = 8, grew = 16 };

  double drawShareOfRecruitment(AgentId id) const;
  /// What is left of the step, and of the one before by the clock, for a cell in G0 that no rule arrests once
  /// it has entered G1; not above 0 where it does not.
  double leftAfterEntry(const AgentStore& agents, Index i, double time) const;
  std::uint8_t advanceCell(AgentStore& agents, Index i, const ArrestRules& rules, double time) const;

  CellCycleParameters p_;
  std::uint64_t seed_;
  double step_;
  std::optional<Activation> activation_;
};

}  // namespace restenosis

#pragma once

#include <limits>
#include <string>
#include <string_view>

#include "tissue/agents/AgentStore.h"

namespace restenosis {

/// A rule by which cells rest (model 5): a cell that any rule arrests does not leave G0, and is sent back to
/// G0 from G1. From S on no rule applies. Rules are stateless and see one cell at a time.
///
/// A rule that reads wall shear stress, itself or through nitric oxide, says so here and nowhere else: when
/// the flow must be solved follows from these answers (ArrestRules). By default such a rule reads the stress
/// of every cell, and any change of it may change the answer; a rule that overrides this saves solves.
class ArrestRule {
 public:
  virtual ~ArrestRule() = default;
  virtual bool arrests(const AgentStore& agents, Index cell) const = 0;

  /// Whether wall shear stress enters the answer for any cell.
  virtual bool readsWss() const { return false; }
  /// Whether wall shear stress enters the answer for this cell, as the cell is now.
  virtual bool readsWssOf(const AgentStore&, Index) const { return readsWss(); }
  /// The WSS [Pa] at and above which the answer stays the same.
  virtual double decidingWss() const { return std::numeric_limits<double>::infinity(); }
  /// Whether a small change of wall shear stress may change the answer for this cell: whether it has less
  /// than `margin` times the stress that decides.
  virtual bool undecided(const AgentStore& agents, Index cell, double margin) const {
    return agents.wss[cell] < margin * decidingWss();
  }
  /// Why wall shear stress enters no answer until `time` [s after deployment], or empty.
  virtual std::string readsNoWssUntil(double /*time*/) const { return {}; }

  /// When wall shear stress enters the answer for some cell, for messages.
  virtual std::string whenWssIsRead() const { return "from the start, when a cell could still cycle"; }
  /// Reasons for not solving the flow: the rule reads the stress of no cell; it reads that of some cells, all
  /// of which rest or divide by other rules.
  virtual std::string_view whenNoCellReads() const { return "no cell reads its wall shear stress"; }
  virtual std::string_view whenAllAreDecided() const {
    return "every cell rests or divides whatever its wall shear stress";
  }
};

}  // namespace restenosis

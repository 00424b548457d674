#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tissue/agents/AgentStore.h"
#include "tissue/biology/ArrestRule.h"
#include "tissue/biology/BiologySettings.h"

namespace restenosis {

/// Makes a rule; null where the settings do not ask for it.
using MakeArrestRule = std::unique_ptr<const ArrestRule> (*)(const BiologySettings&);

/// All rules. To add one, write its file and an entry of the table in ArrestRules.cpp.
std::span<const MakeArrestRule> arrestRuleTable();

/// The rules by which the cells of a scene rest: the cell cycle asks whether a cell rests, the schedule of
/// the flow whether wall shear stress can change that. One set of rules answers both.
class ArrestRules {
 public:
  /// Throws std::invalid_argument for an unknown scenario and for nitric oxide that falls with WSS.
  explicit ArrestRules(const BiologySettings& settings,
                       std::span<const MakeArrestRule> table = arrestRuleTable());

  /// Whether any rule arrests the cell.
  bool arrest(const AgentStore& agents, Index cell) const;

  /// Whether any rule reads wall shear stress.
  bool readWss() const;
  /// Why no rule does until `time` [s after deployment], or empty.
  std::string readNoWssUntil(double time) const;
  /// When the rules that read wall shear stress do so, for messages; empty where none does.
  std::string whenWssIsRead() const;
  /// Why wall shear stress can change the state of no cell now; empty where it can change one.
  std::string_view wssChangesNothingBecause(const AgentStore& agents) const;
  /// Whether wall shear stress can change the state of this cell: it is a free smooth muscle cell before S,
  /// some rule reads its stress, and none of the others arrests it.
  bool wssMayChange(const AgentStore& agents, Index cell) const;
  /// Cells for which a small change of wall shear stress may change the state: those of wssMayChange() with
  /// less than `margin` times the WSS that decides (ArrestRule::undecided). A cell with more stays
  /// arrested.
  std::vector<Index> undecidedCells(const AgentStore& agents, double margin) const;

 private:
  std::vector<std::unique_ptr<const ArrestRule>> rules_;
};

}  // namespace restenosis

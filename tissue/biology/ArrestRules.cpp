#include "tissue/biology/ArrestRules.h"

#include <algorithm>
#include <array>
#include <ranges>

#include "tissue/biology/CellCycle.h"
#include "tissue/biology/ContractileArrest.h"
#include "tissue/biology/InhibitionArrest.h"
#include "tissue/biology/NitricOxideArrest.h"

namespace restenosis {
namespace {

constexpr std::array<MakeArrestRule, 3> arrestRules{
    ContractileArrest::make,
    InhibitionArrest::make,
    NitricOxideArrest::make,
};

}  // namespace

std::span<const MakeArrestRule> arrestRuleTable() { return arrestRules; }

ArrestRules::ArrestRules(const BiologySettings& settings, std::span<const MakeArrestRule> table) {
  for (const MakeArrestRule make : table)
    if (auto rule = make(settings)) rules_.push_back(std::move(rule));
}

bool ArrestRules::arrest(const AgentStore& agents, Index cell) const {
  return std::ranges::any_of(rules_, [&](const auto& rule) { return rule->arrests(agents, cell); });
}

bool ArrestRules::readWss() const {
  return std::ranges::any_of(rules_, [](const auto& rule) { return rule->readsWss(); });
}

std::string ArrestRules::readNoWssUntil(double time) const {
  std::string first;
  for (const auto& rule : rules_) {
    if (!rule->readsWss()) continue;
    const std::string reason = rule->readsNoWssUntil(time);
    if (reason.empty()) return {};
    if (first.empty()) first = reason;
  }
  return first;
}

std::string ArrestRules::whenWssIsRead() const {
  std::string text;
  for (const auto& rule : rules_)
    if (rule->readsWss()) text += (text.empty() ? "" : ", or ") + rule->whenWssIsRead();
  return text;
}

bool ArrestRules::wssMayChange(const AgentStore& agents, Index cell) const {
  if (!CellCycle::obeysRules(agents, cell)) return false;
  bool read = false;
  for (const auto& rule : rules_) {
    if (rule->readsWssOf(agents, cell))
      read = true;
    else if (rule->arrests(agents, cell))
      return false;
  }
  return read;
}

std::string_view ArrestRules::wssChangesNothingBecause(const AgentStore& agents) const {
  const auto anyCell = [&](auto&& condition) {
    for (Index i = 0; i < agents.size(); ++i)
      if (condition(i)) return true;
    return false;
  };
  if (anyCell([&](Index i) { return wssMayChange(agents, i); })) return {};
  std::string_view reason = "no rule reads wall shear stress";
  for (const auto& rule : rules_ | std::views::reverse) {
    if (rule->readsWss()) reason = rule->whenNoCellReads();
  }
  for (const auto& rule : rules_) {
    if (anyCell([&](Index i) { return agents.kind[i] == AgentKind::smc && rule->readsWssOf(agents, i); }))
      return rule->whenAllAreDecided();
  }
  return reason;
}

std::vector<Index> ArrestRules::undecidedCells(const AgentStore& agents, double margin) const {
  std::vector<Index> cells;
  for (Index i = 0; i < agents.size(); ++i) {
    if (!wssMayChange(agents, i)) continue;
    const bool undecided = std::ranges::any_of(rules_, [&](const auto& rule) {
      return rule->readsWssOf(agents, i) && rule->undecided(agents, i, margin);
    });
    if (undecided) cells.push_back(i);
  }
  return cells;
}

}  // namespace restenosis

#include "tissue/biology/CellCycle.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "tissue/agents/Chunks.h"
#include "tissue/agents/RandomStream.h"

namespace restenosis {

namespace {

const double doubledRadius = std::cbrt(2.0);

/// Relative to a phase and a step: a phase that lacks less has ended, for clocks are rounded sums of steps. A
/// phase of a whole number of steps must not last one more.
constexpr double rounding = 1e-9;

}  // namespace

CellCycle::CellCycle(const CellCycleParameters& parameters, std::uint64_t seed, double step,
                     const std::optional<Activation>& activation)
    : p_(parameters), seed_(seed), step_(step), activation_(activation) {}

double CellCycle::drawG1Duration(AgentId id, std::uint32_t generation) const {
  RandomStream random(seed_, id, generation, RandomPurpose::g1Duration);
  double deviate = random.normal();
  while (std::abs(deviate) > 3) deviate = random.normal();
  return std::max(0.0, p_.g1Mean + p_.g1Spread * deviate);
}

double CellCycle::drawShareOfRecruitment(AgentId id) const {
  return RandomStream(seed_, id, 0, RandomPurpose::recruitment).uniform();
}

double CellCycle::drawRecruitment(AgentId id) const { return drawShareOfRecruitment(id) * p_.recruitment; }

double CellCycle::leftAfterEntry(const AgentStore& agents, Index i, double time) const {
  double left = step_;
  if (activation_) {
    assert(std::isfinite(time));
    left += agents.clock[i];
    return left - activation_->entry(agents, i, left, static_cast<std::uint32_t>(std::lround(time / step_)));
  }
  if (time < p_.recruitment && agents.generation[i] == 0) {
    // From recruitment to the end of the step. fma: one rounding, whether or not the draw is inlined.
    const double since = std::fma(-drawShareOfRecruitment(agents.id[i]), p_.recruitment, time + step_);
    left = std::min(left, since);
    if (left <= 0) return left;
  }
  return left + agents.clock[i];
}

std::uint8_t CellCycle::advanceCell(AgentStore& agents, Index i, const ArrestRules& rules,
                                    double time) const {
  std::uint8_t passed = 0;
  const auto pass = [&passed](Passage passage) { passed |= static_cast<std::uint8_t>(passage); };
  double& clock = agents.clock[i];
  double left = step_;

  if (obeysRules(agents, i) && rules.arrest(agents, i)) {
    if (agents.state[i] == CycleState::g1) pass(Passage::arrested);
    agents.state[i] = CycleState::g0;
    clock = 0;
    return passed;
  }
  if (agents.state[i] == CycleState::g0) {
    left = leftAfterEntry(agents, i, time);
    if (left <= 0) {
      if (activation_) clock = 0;
      return passed;
    }
    clock = 0;
    agents.state[i] = CycleState::g1;
    if (agents.g1Duration[i] <= 0) {
      agents.g1Duration[i] = drawG1Duration(agents.id[i], agents.generation[i]);
    }
    pass(Passage::enteredG1);
  }
  if (agents.state[i] == CycleState::g1) {
    const double duration = agents.g1Duration[i];
    const double target = agents.birthRadius[i] * doubledRadius;
    if (clock + left < duration - rounding * (duration + step_)) {
      const double grown = agents.cellRadius(i) * std::exp2(left / (3 * duration));
      agents.setCell(i, std::min(grown, target), agents.matrix[i]);
      clock += left;
      return passed;
    }
    left = std::max(0.0, left - (duration - clock));
    clock = 0;
    agents.setCell(i, target, agents.matrix[i]);
    agents.state[i] = CycleState::sg2m;
    pass(Passage::enteredSg2m);
  }
  clock += left;
  if (clock >= p_.sg2mDuration - rounding * (p_.sg2mDuration + step_)) {
    clock = std::clamp(clock - p_.sg2mDuration, 0.0, step_);
    pass(Passage::divides);
  }
  return passed;
}

std::vector<Index> CellCycle::advance(AgentStore& agents, const ArrestRules& rules, CycleReport& report,
                                      double time) const {
  // Each cell reads and writes itself only, so the order of cells does not matter.
  std::vector<std::uint8_t> passed(agents.size(), 0);
  forEachInChunks(agents.size(), [&](std::size_t k) {
    const auto i = static_cast<Index>(k);
    if (!cycles(agents, i)) return;
    const double radius = agents.radius[i];
    passed[i] = advanceCell(agents, i, rules, time);
    if (agents.radius[i] != radius) passed[i] |= static_cast<std::uint8_t>(Passage::grew);
  });

  std::vector<Index> dividing;
  for (const Index i : agentsThat(agents.size(), [&](Index i) { return passed[i] != 0; })) {
    const auto did = [&](Passage p) { return (passed[i] & static_cast<std::uint8_t>(p)) != 0; };
    report.enteredG1 += did(Passage::enteredG1);
    report.arrested += did(Passage::arrested);
    report.enteredSg2m += did(Passage::enteredSg2m);
    report.anyGrew |= did(Passage::grew);
    if (did(Passage::divides)) dividing.push_back(i);
  }
  std::ranges::sort(dividing, {}, [&](Index i) { return agents.id[i]; });
  return dividing;
}

}  // namespace restenosis

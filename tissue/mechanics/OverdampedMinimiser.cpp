#include "OverdampedMinimiser.h"

#include <algorithm>

namespace restenosis {
namespace {

// Euler's method is stable up to 1 in units of 1 / stiffness; a little less damps the stiffest mode.
constexpr double stableShare = 0.9;

}  // namespace

OverdampedMinimiser::OverdampedMinimiser(const MechanicsParameters& parameters)
    : axialFactor_(parameters.axialForceFactor), stepLimit_(parameters.stepLimit) {}

void OverdampedMinimiser::total(std::span<const AgentMotion> agents, StepTotals& totals) const {
  for (const AgentMotion& agent : agents) totals.stiffest = std::max(totals.stiffest, agent.now.stiffness);
}

void OverdampedMinimiser::begin(const StepTotals& totals) {
  mobility_ = stableShare / (totals.stiffest * std::max(1.0, axialFactor_));
}

void OverdampedMinimiser::step(std::span<AgentMotion> agents, std::span<Vec3> moves) const {
  for (std::size_t k = 0; k < agents.size(); ++k) {
    Vec3 move = mobility_ * agents[k].now.force;
    move.z() *= axialFactor_;
    const double length = move.norm(), limit = stepLimit_ * agents[k].radius;
    if (length > limit) move *= limit / length;
    moves[k] = move;
  }
}

}  // namespace restenosis

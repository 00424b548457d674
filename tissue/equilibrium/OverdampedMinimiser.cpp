#include "tissue/equilibrium/OverdampedMinimiser.h"

#include <algorithm>

namespace restenosis {
namespace {

// Euler's method is stable up to 1 in units of 1 / stiffness; a little less damps the stiffest mode.
constexpr double stableShare = 0.9;

}  // namespace

OverdampedMinimiser::OverdampedMinimiser(const RelaxationParameters& parameters)
    : axialFactor_(parameters.axialForceFactor), stepLimit_(longestShare * parameters.stepLimit) {}

void OverdampedMinimiser::total(const ActiveChunk& agents, std::size_t count, StepTotals& totals) const {
  for (std::size_t k = 0; k < count; ++k)
    totals.stiffest = std::max<double>(totals.stiffest, agents.stiffness[k]);
}

void OverdampedMinimiser::begin(const StepTotals& totals) {
  mobility_ = stableShare / (totals.stiffest * std::max(1.0, axialFactor_));
}

void OverdampedMinimiser::step(ActiveChunk& agents, std::size_t count, Moves& moves) const {
  for (std::size_t k = 0; k < count; ++k) {
    Vec3 move = mobility_ * Vec3(agents.fx[k], agents.fy[k], agents.fz[k]);
    move.z() *= axialFactor_;
    const double length = move.norm(), limit = stepLimit_ * agents.radius[k];
    if (length > limit) move *= limit / length;
    moves.x[k] = static_cast<float>(move.x());
    moves.y[k] = static_cast<float>(move.y());
    moves.z[k] = static_cast<float>(move.z());
  }
}

}  // namespace restenosis

#include "OverdampedMinimiser.h"

#include <algorithm>

namespace restenosis {
namespace {

// Euler's method is stable up to 1 in units of 1 / stiffness; a little less damps the stiffest mode.
constexpr double stableShare = 0.9;

}  // namespace

OverdampedMinimiser::OverdampedMinimiser(const MechanicsParameters& parameters)
    : axialFactor_(parameters.axialForceFactor), stepLimit_(parameters.stepLimit) {}

void OverdampedMinimiser::total(const MinimiserView& view, std::size_t begin, std::size_t end,
                                StepTotals& totals) const {
  for (std::size_t k = begin; k < end; ++k)
    totals.stiffest = std::max(totals.stiffest, view.motion[view.active[k]].stiffness);
}

void OverdampedMinimiser::begin(const StepTotals& totals) {
  mobility_ = stableShare / (totals.stiffest * std::max(1.0, axialFactor_));
}

void OverdampedMinimiser::step(const MinimiserView& view, std::size_t begin, std::size_t end,
                               std::span<Vec3> moves) const {
  for (std::size_t k = begin; k < end; ++k) {
    const Index i = view.active[k];
    Vec3 move = mobility_ * view.motion[i].force;
    move.z() *= axialFactor_;
    const double length = move.norm(), limit = stepLimit_ * view.radius[i];
    if (length > limit) move *= limit / length;
    moves[k - begin] = move;
  }
}

}  // namespace restenosis

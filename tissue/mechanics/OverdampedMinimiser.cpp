#include "OverdampedMinimiser.h"

#include <algorithm>

#include "Chunks.h"

namespace restenosis {
namespace {

// Euler's method is stable up to 1 in units of 1 / stiffness; a little less damps the stiffest mode.
constexpr double stableShare = 0.9;

struct Largest {
  double value = 0;
  void join(const Largest& other) { value = std::max(value, other.value); }
};

}  // namespace

OverdampedMinimiser::OverdampedMinimiser(const MechanicsParameters& parameters)
    : axialFactor_(parameters.axialForceFactor), stepLimit_(parameters.stepLimit) {}

void OverdampedMinimiser::step(const MinimiserView& view) {
  const auto largest = reduceInChunks<Largest>(view.active.size(), [&](std::size_t k, Largest& part) {
    part.value = std::max(part.value, view.stiffness[view.active[k]]);
  });
  const double mobility = stableShare / (largest.value * std::max(1.0, axialFactor_));
  forEachInChunks(view.active.size(), [&](std::size_t k) {
    const Index i = view.active[k];
    Vec3 move = mobility * view.force[i];
    move.z() *= axialFactor_;
    const double length = move.norm(), limit = stepLimit_ * view.radius[i];
    if (length > limit) move *= limit / length;
    view.step[k] = move;
  });
}

}  // namespace restenosis

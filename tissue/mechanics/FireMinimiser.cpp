#include "FireMinimiser.h"

#include <algorithm>
#include <cmath>

namespace restenosis {
namespace {

// Bitzek et al. 2006, except the time steps, which are in units of sqrt(mass / stiffness) here.
constexpr double firstTimeStep = 0.4, largestTimeStep = 1.35;
constexpr double grow = 1.1, shrink = 0.5;
constexpr double firstMixing = 0.1, mixingDecay = 0.99;
constexpr int stepsBeforeGrowth = 5;
constexpr double uphillShare = 0.5;   // of its velocity that an agent keeps while it moves against its force
constexpr double steadyShare = 0.95;  // of the bound on steering

/// Mobilities are 1 / mass, the axial one times the axial factor; the larger of the two is 1 / stiffness.
Vec3 mobilityShares(double axialFactor) {
  const double slower = 1 / std::max(1.0, axialFactor);
  return {slower, slower, slower * axialFactor};
}

/// The velocity an agent sets out with.
Vec3 slowedUphill(const AgentMotion& motion, double power) {
  if (power > 0) return motion.velocity;
  return motion.velocity * (motion.force.isZero(0) ? 0 : uphillShare);
}

}  // namespace

FireMinimiser::FireMinimiser(const MechanicsParameters& parameters)
    : mobilityShare_(mobilityShares(parameters.axialForceFactor)),
      stepLimit_(parameters.stepLimit),
      timeStep_(firstTimeStep),
      mixing_(firstMixing) {}

void FireMinimiser::total(const MinimiserView& view, std::size_t begin, std::size_t end,
                          StepTotals& totals) const {
  for (std::size_t k = begin; k < end; ++k) {
    const AgentMotion& motion = view.motion[view.active[k]];
    const Vec3 mobility = mobilityShare_ / motion.stiffness;
    const double power = motion.force.dot(motion.velocity);
    const Vec3 velocity = slowedUphill(motion, power);
    totals.power += power;
    totals.velocity += velocity.dot(velocity.cwiseQuotient(mobility));
    totals.force += motion.force.dot(motion.force.cwiseProduct(mobility));
  }
}

void FireMinimiser::begin(const StepTotals& totals) {
  const bool downhill = totals.power >= 0;
  if (!downhill) {
    downhillSteps_ = 0;
    timeStep_ *= shrink;
    mixing_ = firstMixing;
  } else if (++downhillSteps_ > stepsBeforeGrowth) {
    timeStep_ = std::min(timeStep_ * grow, largestTimeStep);
    mixing_ *= mixingDecay;
  }
  keep_ = downhill ? 1 - mixing_ : 0;
  steer_ = downhill && totals.force > 0 ? mixing_ * std::sqrt(totals.velocity / totals.force) : 0;
  // Where much drifts along a slope that hardly pulls, the root is large, and steering would shake the
  // stiffest agents. A mode of eigenvalue w, at most 2, swings up once w dt (dt + steer) > 2 (1 + kept): it
  // goes against its force in every step and keeps the uphill share of its velocity only.
  const double borne = steadyShare * (1 + uphillShare * keep_) / timeStep_;
  steer_ = std::min(steer_, std::max(0.0, borne - timeStep_));
}

void FireMinimiser::step(const MinimiserView& view, std::size_t begin, std::size_t end,
                         std::span<Vec3> moves) const {
  for (std::size_t k = begin; k < end; ++k) {
    const Index i = view.active[k];
    AgentMotion& motion = view.motion[i];
    const Vec3 slowed = slowedUphill(motion, motion.force.dot(motion.velocity));
    const Vec3 pace = motion.force.cwiseProduct(mobilityShare_ / motion.stiffness);
    motion.velocity = keep_ * slowed + (steer_ + timeStep_) * pace;
    const double length = motion.velocity.norm() * timeStep_, limit = stepLimit_ * view.radius[i];
    if (length > limit) motion.velocity *= limit / length;
    moves[k - begin] = timeStep_ * motion.velocity;
  }
}

}  // namespace restenosis

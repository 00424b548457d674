#include "tissue/equilibrium/FireMinimiser.h"

#include <algorithm>
#include <cmath>

namespace restenosis {
namespace {

// Bitzek et al. 2006, except the time steps, which are in units of sqrt(mass / stiffness) here.
constexpr double firstTimeStep = 0.4, largestTimeStep = 1.35;
constexpr double grow = 1.1, shrink = 0.5;
constexpr double firstMixing = 0.1, mixingDecay = 0.99;
constexpr int stepsBeforeGrowth = 5;
constexpr float uphillShare = 0.5;    // of its velocity that an agent keeps while it moves against its force
constexpr double steadyShare = 0.95;  // of the bound on steering

/// Mobilities are 1 / mass, the axial one times the axial factor; the larger of the two is 1 / stiffness.
Eigen::Vector3f mobilityShares(double axialFactor) {
  const double slower = 1 / std::max(1.0, axialFactor);
  return Vec3(slower, slower, slower * axialFactor).cast<float>();
}

using Values = ActiveChunk::Values;

/// Three components of several agents.
struct Vectors {
  Values x, y, z;
  Vectors(const Values& ofX, const Values& ofY, const Values& ofZ) : x(ofX), y(ofY), z(ofZ) {}
  Vectors(const ActiveChunk::Floats& ofX, const ActiveChunk::Floats& ofY, const ActiveChunk::Floats& ofZ,
          std::size_t k)
      : x(Values::from(&ofX[k])), y(Values::from(&ofY[k])), z(Values::from(&ofZ[k])) {}
  Values dot(const Vectors& o) const { return x * o.x + y * o.y + z * o.z; }
  /// Of their squares, each component times its weight.
  Values squares(const Eigen::Vector3f& weight) const {
    return x * x * weight.x() + y * y * weight.y() + z * z * weight.z();
  }
};

Vectors velocities(const ActiveChunk& agents, std::size_t k) { return {agents.vx, agents.vy, agents.vz, k}; }
Vectors forces(const ActiveChunk& agents, std::size_t k) { return {agents.fx, agents.fy, agents.fz, k}; }

/// The shares of their velocities that agents set out with.
Values keptUphill(const Vectors& force, const Values& power) {
  const auto downhill = Values(0) < power;
  const auto none = (force.x == Values(0)) & (force.y == Values(0)) & (force.z == Values(0));
  return Values(1).where(downhill) + Values(uphillShare).where(~downhill & ~none);
}

}  // namespace

FireMinimiser::FireMinimiser(const RelaxationParameters& parameters)
    : mobilityShare_(mobilityShares(parameters.axialForceFactor)),
      massShare_(mobilityShare_.cwiseInverse()),
      stepLimit_(longestShare * parameters.stepLimit),
      timeStep_(firstTimeStep),
      mixing_(firstMixing) {}

void FireMinimiser::total(const ActiveChunk& agents, std::size_t count, StepTotals& totals) const {
  Values powers = 0, ofVelocities = 0, ofForces = 0;
  for (std::size_t k = 0; k < count; k += ActiveChunk::lanes) {
    const Vectors force = forces(agents, k), velocity = velocities(agents, k);
    const Values stiffness = Values::from(&agents.stiffness[k]);
    const Values power = force.dot(velocity), kept = keptUphill(force, power);
    powers += power;
    ofVelocities += kept * kept * stiffness * velocity.squares(massShare_);
    ofForces += force.squares(mobilityShare_) / stiffness;
  }
  totals.power += powers.sum();
  totals.velocity += ofVelocities.sum();
  totals.force += ofForces.sum();
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

void FireMinimiser::step(ActiveChunk& agents, std::size_t count, Moves& moves) const {
  const Values keep = static_cast<float>(keep_), push = static_cast<float>(steer_ + timeStep_),
               limit = static_cast<float>(stepLimit_ / timeStep_), timeStep = static_cast<float>(timeStep_);
  for (std::size_t k = 0; k < count; k += ActiveChunk::lanes) {
    const Vectors force = forces(agents, k), before = velocities(agents, k);
    const Values kept = keep * keptUphill(force, force.dot(before));
    const Values pushed = push / Values::from(&agents.stiffness[k]);
    const Vectors velocity(kept * before.x + pushed * mobilityShare_.x() * force.x,
                           kept * before.y + pushed * mobilityShare_.y() * force.y,
                           kept * before.z + pushed * mobilityShare_.z() * force.z);
    const Values fastest = limit * Values::from(&agents.radius[k]);
    const Values squared = velocity.dot(velocity);
    const auto tooFast = fastest * fastest < squared;
    const Values slowed = Values(1).where(~tooFast) + (fastest / squared.sqrt()).where(tooFast);
    const auto put = [&](const Values& component, float& ofAgent, float& move) {
      const Values bounded = component * slowed;
      bounded.store(&ofAgent);
      (timeStep * bounded).store(&move);
    };
    put(velocity.x, agents.vx[k], moves.x[k]);
    put(velocity.y, agents.vy[k], moves.y[k]);
    put(velocity.z, agents.vz[k], moves.z[k]);
  }
}

}  // namespace restenosis

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

/// The share of its velocity that an agent sets out with.
double keptUphill(const AgentMotion& agent, double power) {
  if (power > 0) return 1;
  return agent.now.force.isZero(0) ? 0 : uphillShare;
}

}  // namespace

FireMinimiser::FireMinimiser(const MechanicsParameters& parameters)
    : mobilityShare_(mobilityShares(parameters.axialForceFactor)),
      massShare_(mobilityShare_.cwiseInverse()),
      stepLimit_(parameters.stepLimit),
      timeStep_(firstTimeStep),
      mixing_(firstMixing) {}

void FireMinimiser::total(std::span<const AgentMotion> agents, StepTotals& totals) const {
  for (const AgentMotion& agent : agents) {
    const Vec3& force = agent.now.force;
    const double power = force.dot(agent.velocity), kept = keptUphill(agent, power);
    totals.power += power;
    totals.velocity += kept * kept * agent.now.stiffness * agent.velocity.cwiseAbs2().dot(massShare_);
    totals.force += force.cwiseAbs2().dot(mobilityShare_) / agent.now.stiffness;
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

void FireMinimiser::step(std::span<AgentMotion> agents, std::span<Vec3> moves) const {
  for (std::size_t k = 0; k < agents.size(); ++k) {
    AgentMotion& agent = agents[k];
    const Vec3& force = agent.now.force;
    const double kept = keep_ * keptUphill(agent, force.dot(agent.velocity));
    const double pushed = (steer_ + timeStep_) / agent.now.stiffness;
    agent.velocity = kept * agent.velocity + pushed * force.cwiseProduct(mobilityShare_);
    const double fastest = stepLimit_ * agent.radius / timeStep_;
    const double squared = agent.velocity.squaredNorm();
    if (squared > fastest * fastest) agent.velocity *= fastest / std::sqrt(squared);
    moves[k] = timeStep_ * agent.velocity;
  }
}

}  // namespace restenosis

#include "FireMinimiser.h"

#include <algorithm>
#include <cmath>

#include "Chunks.h"

namespace restenosis {
namespace {

// Bitzek et al. 2006, except the time steps, which are in units of sqrt(mass / stiffness) here.
constexpr double firstTimeStep = 0.4, largestTimeStep = 1.4;
constexpr double grow = 1.1, shrink = 0.5;
constexpr double firstMixing = 0.1, mixingDecay = 0.99;
constexpr int stepsBeforeGrowth = 5;
constexpr double uphillShare = 0.5;  // of its velocity that an agent keeps while it moves against its force

struct Sums {
  double power = 0;     ///< F . v, before agents moving uphill are slowed
  double velocity = 0;  ///< v . M v
  double force = 0;     ///< F . F / M
  void join(const Sums& o) { power += o.power, velocity += o.velocity, force += o.force; }
};

}  // namespace

FireMinimiser::FireMinimiser(const MechanicsParameters& parameters)
    : axialFactor_(parameters.axialForceFactor),
      stepLimit_(parameters.stepLimit),
      timeStep_(firstTimeStep),
      mixing_(firstMixing) {}

void FireMinimiser::step(const MinimiserView& view) {
  // Mobilities: 1 / mass, the axial one times the axial factor; the larger of the two is 1 / stiffness.
  const double slower = 1 / std::max(1.0, axialFactor_);
  const Vec3 share(slower, slower, slower * axialFactor_);

  const auto sums = reduceInChunks<Sums>(view.active.size(), [&](std::size_t k, Sums& part) {
    const Index i = view.active[k];
    const Vec3 &force = view.force[i], mobility = share / view.stiffness[i];
    Vec3& velocity = view.velocity[i];
    const double power = force.dot(velocity);
    part.power += power;
    if (!(power > 0)) velocity *= force.isZero(0) ? 0 : uphillShare;
    part.velocity += velocity.dot(velocity.cwiseQuotient(mobility));
    part.force += force.dot(force.cwiseProduct(mobility));
  });

  const bool downhill = sums.power >= 0;
  if (!downhill) {
    downhillSteps_ = 0;
    timeStep_ *= shrink;
    mixing_ = firstMixing;
  } else if (++downhillSteps_ > stepsBeforeGrowth) {
    timeStep_ = std::min(timeStep_ * grow, largestTimeStep);
    mixing_ *= mixingDecay;
  }
  const double keep = downhill ? 1 - mixing_ : 0;
  const double steer = downhill && sums.force > 0 ? mixing_ * std::sqrt(sums.velocity / sums.force) : 0;

  forEachInChunks(view.active.size(), [&](std::size_t k) {
    const Index i = view.active[k];
    const Vec3 pace = view.force[i].cwiseProduct(share / view.stiffness[i]);
    Vec3& velocity = view.velocity[i];
    velocity = keep * velocity + (steer + timeStep_) * pace;
    const double length = velocity.norm() * timeStep_, limit = stepLimit_ * view.radius[i];
    if (length > limit) velocity *= limit / length;
    view.step[k] = timeStep_ * velocity;
  });
}

}  // namespace restenosis

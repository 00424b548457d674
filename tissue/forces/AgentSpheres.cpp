#include "tissue/forces/AgentSpheres.h"

#include <algorithm>
#include <cmath>

#include "tissue/agents/Chunks.h"

namespace restenosis {
namespace {

Sphere exactSphere(const AgentStore& agents, Index i) {
  return {agents.x[i], agents.y[i], agents.z[i], agents.radius[i]};
}

FixedSphere fixedSphere(const AgentStore& agents, Index i, const FixedScale& scale) {
  return fixedSphere(scale, agents.position(i), static_cast<float>(agents.radius[i]));
}

/// From b to a [m].
Vec3 apart(const Sphere& a, const Sphere& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Vec3 apart(const FixedSphere& a, const FixedSphere& b, const FixedScale& scale) {
  const auto units = [](std::uint32_t u, std::uint32_t v) {
    return static_cast<double>(static_cast<std::int32_t>(u - v));
  };
  return scale.unit() * Vec3(units(a.x, b.x), units(a.y, b.y), units(a.z, b.z));
}

}  // namespace

void AgentSpheres::copyAll() {
  scale_ = wanted_;
  if (scale_ && !agentsThat(agents_.size(), [this](Index i) { return !fits(i); }).empty()) scale_.reset();
  none_ = agents_.size() + agents_.size() / 8;
  exact_ = scale_ ? std::vector<Sphere>() : packSpheres(agents_, none_);
  fixed_ = scale_ ? packSpheres(agents_, none_, *scale_) : std::vector<FixedSphere>();
}

bool AgentSpheres::fits(Index i) const {
  const double limit = wanted_->reach() / 4;
  return agents_.radius[i] <= limit && std::ranges::all_of(bonds_.of(i), [&](const Bond& bond) {
           return (agents_.position(i) - agents_.position(bond.partner)).squaredNorm() <= limit * limit;
         });
}

bool AgentSpheres::precisionHolds(std::span<const Index> changed) const {
  if (!wanted_) return true;
  return scale_ && agentsOf(changed, [this](Index i) { return !fits(i); }).empty();
}

void AgentSpheres::copy(Index i) {
  if (scale_) {
    fixed_[i] = fixedSphere(agents_, i, *scale_);
  } else {
    exact_[i] = exactSphere(agents_, i);
  }
}

bool AgentSpheres::changed(Index i) const {
  return scale_ ? fixed_[i] != fixedSphere(agents_, i, *scale_) : exact_[i] != exactSphere(agents_, i);
}

AgentSpheres::Change AgentSpheres::changeOf(Index i) const {
  if (!scale_) {
    const Sphere now = exactSphere(agents_, i);
    return {apart(now, exact_[i]).norm(), std::abs(now.r - exact_[i].r)};
  }
  const FixedSphere now = fixedSphere(agents_, i, *scale_);
  return {apart(now, fixed_[i], *scale_).norm(), std::abs(static_cast<double>(now.r) - fixed_[i].r)};
}

}  // namespace restenosis

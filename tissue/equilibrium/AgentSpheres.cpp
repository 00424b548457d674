#include "tissue/equilibrium/AgentSpheres.h"

#include <algorithm>

#include "tissue/agents/Chunks.h"

namespace restenosis {

void AgentSpheres::choosePrecision() {
  scale_ = wanted_;
  if (scale_ && !agentsThat(agents_.size(), [this](Index i) { return !fits(i); }).empty()) scale_.reset();
  outgrown_ = scale_.has_value() != wanted_.has_value();
}

bool AgentSpheres::fits(Index i) const {
  const double within = scale_->reach() / 4;
  return agents_.radius[i] <= within && std::ranges::all_of(bonds_.of(i), [&](const Bond& bond) {
           return (agents_.position(i) - agents_.position(bond.partner)).squaredNorm() <= within * within;
         });
}

bool AgentSpheres::fit(std::span<const Index> agents) const {
  return !scale_ || agentsOf(agents, [this](Index i) { return !fits(i); }).empty();
}

void AgentSpheres::packAll() {
  nobody_ = agents_.size() + agents_.size() / 8;
  spheres_ = packSpheres(agents_, nobody_);
  if (scale_) fixed_ = packSpheres(agents_, nobody_, *scale_);
}

void AgentSpheres::copy(Index i) {
  spheres_[i] = {agents_.x[i], agents_.y[i], agents_.z[i], agents_.radius[i]};
  if (scale_) fixed_[i] = fixedSphere(*scale_, agents_.position(i), static_cast<float>(agents_.radius[i]));
}

bool AgentSpheres::changed(Index i) const {
  const Sphere& s = spheres_[i];
  return s.x != agents_.x[i] || s.y != agents_.y[i] || s.z != agents_.z[i] || s.r != agents_.radius[i];
}

void AgentSpheres::remember(std::span<const Index> moved) {
  forEachInChunks(moved.size(), [&](std::size_t k) {
    const Index i = moved[k];
    spheres_[i] = {agents_.x[i], agents_.y[i], agents_.z[i], agents_.radius[i]};
  });
  outgrown_ = outgrown_ || !fit(moved);
}

}  // namespace restenosis

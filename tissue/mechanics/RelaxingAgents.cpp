#include "RelaxingAgents.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "Chunks.h"

namespace restenosis {
namespace {

struct Any {
  bool found = false;
  Index agent = 0;
  void join(const Any& other) {
    if (!found && other.found) *this = other;
  }
};

struct Largest {
  double value = 0;
  void join(const Largest& other) { value = std::max(value, other.value); }
};

void requireSound(const AgentStore& agents, const BondTable& bonds) {
  if (bonds.size() != agents.size()) {
    throw std::invalid_argument(
        fmt::format("the bond table has room for {} agents, there are {}: call BondTable::resize",
                    bonds.size(), agents.size()));
  }
  for (Index i = 0; i < agents.size(); ++i) {
    if (agents.radius[i] > 0 && std::isfinite(agents.radius[i])) continue;
    throw std::invalid_argument(fmt::format("agent {} has the radius {} m; radii are finite and above 0",
                                            agents.id[i], agents.radius[i]));
  }
}

}  // namespace

RelaxingAgents::RelaxingAgents(AgentStore& agents, const BondTable& bonds,
                               std::span<const Constraint* const> constraints, const ForceField& field,
                               double softest, double tolerance, NeighbourList& neighbours, double skin)
    : agents_(agents),
      bonds_(bonds),
      constraints_(constraints),
      field_(field),
      softest_(softest),
      tolerance_(tolerance),
      neighbours_(neighbours),
      range_(field.range(skin)),
      load_(agents.size()),
      force_(agents.size(), Vec3::Zero()),
      stiffness_(agents.size(), softest),
      residual_(agents.size(), 0.0),
      velocity_(agents.size(), Vec3::Zero()),
      isAwake_(agents.size(), 0),
      marked_(agents.size(), 0) {
  requireSound(agents, bonds);
  for (Index i = 0; i < agents.size(); ++i) {
    if (isFree(i)) free_.push_back(i);
  }
  spheres_ = packSpheres(agents);
  if (!constraints_.empty()) {
    forEachInChunks(free_.size(),
                    [&](std::size_t k) { place(free_[k], projected(free_[k], agents_.position(free_[k]))); });
  }
  neighbours_.update(agents_, range_);
  evaluate(free_);
  std::vector<Index> restless;
  std::ranges::copy_if(free_, std::back_inserter(restless),
                       [&](Index i) { return residual_[i] > tolerance_; });
  wake(restless);
}

bool RelaxingAgents::isFree(Index i) const {
  return !agents_.has(i, AgentFlag::fixed) && agents_.kind[i] != AgentKind::strut;
}

Vec3 RelaxingAgents::projected(Index i, Vec3 position) const {
  for (const Constraint* constraint : constraints_) constraint->project(agents_, i, position);
  return position;
}

void RelaxingAgents::place(Index i, const Vec3& position) {
  agents_.setPosition(i, position);
  spheres_[i].x = position.x(), spheres_[i].y = position.y(), spheres_[i].z = position.z();
}

void RelaxingAgents::evaluate(std::span<const Index> subset) {
  field_.evaluate(spheres_, agents_.flags, neighbours_, bonds_, subset, load_);
  const auto bad = reduceInChunks<Any>(subset.size(), [&](std::size_t k, Any& part) {
    const Index i = subset[k];
    Vec3 force = load_[i].force();
    for (const Constraint* constraint : constraints_) constraint->release(agents_, i, force);
    force_[i] = force;
    stiffness_[i] = std::max(softest_, load_[i].stiffness);
    residual_[i] = force.norm();
    if (!part.found && !std::isfinite(residual_[i])) part = {true, i};
  });
  evaluations_ += subset.size();
  if (bad.found) {
    const auto& f = load_[bad.agent];
    throw std::runtime_error(fmt::format(
        "the force on agent {} at ({}, {}, {}) m is not finite: ({}, {}, {}) N", agents_.id[bad.agent],
        agents_.x[bad.agent], agents_.y[bad.agent], agents_.z[bad.agent], f.fx, f.fy, f.fz));
  }
}

void RelaxingAgents::advance(Minimiser& minimiser) {
  step_.resize(awake_.size());
  minimiser.step({awake_, force_, stiffness_, agents_.radius, velocity_, step_});
  const auto far = reduceInChunks<Any>(awake_.size(), [&](std::size_t k, Any& part) {
    const Index i = awake_[k];
    const Vec3 position = projected(i, agents_.position(i) + step_[k]);
    place(i, position);
    if (!part.found && neighbours_.movedTooFar(i, position)) part = {true, i};
  });
  if (far.found) neighbours_.update(agents_, range_);
  evaluate(awake_);
}

bool RelaxingAgents::wakeDisturbed() {
  if (awake_.size() == free_.size()) return false;
  std::vector<Index> beside;
  const auto consider = [&](Index j) {
    if (isAwake_[j] || marked_[j] || !isFree(j)) return;
    marked_[j] = 1;
    beside.push_back(j);
  };
  for (const Index i : awake_) {
    for (const Index j : neighbours_.of(i)) consider(j);
    for (const Bond& bond : bonds_.of(i)) consider(bond.partner);
  }
  for (const Index j : beside) marked_[j] = 0;
  std::ranges::sort(beside);
  evaluate(beside);
  std::erase_if(beside, [&](Index j) { return residual_[j] <= tolerance_; });
  wake(beside);
  return !beside.empty();
}

void RelaxingAgents::wake(const std::vector<Index>& sleepers) {
  for (const Index i : sleepers) isAwake_[i] = 1;
  const auto middle = static_cast<std::ptrdiff_t>(awake_.size());
  awake_.insert(awake_.end(), sleepers.begin(), sleepers.end());
  std::inplace_merge(awake_.begin(), awake_.begin() + middle, awake_.end());
}

double RelaxingAgents::awakeResidual() const {
  return reduceInChunks<Largest>(
             awake_.size(),
             [&](std::size_t k, Largest& part) { part.value = std::max(part.value, residual_[awake_[k]]); })
      .value;
}

double RelaxingAgents::residual() const { return residual_.empty() ? 0 : residual_[worstAgent()]; }

Index RelaxingAgents::worstAgent() const {
  return static_cast<Index>(std::ranges::max_element(residual_) - residual_.begin());
}

void RelaxingAgents::storePressures() {
  for (const Index i : free_) agents_.pressure[i] = load_[i].pressure;
}

std::uint64_t RelaxingAgents::agentsBeyondLaw() const {
  return static_cast<std::uint64_t>(std::ranges::count_if(
      awake_, [&](Index i) { return field_.overlapOverValid(spheres_, neighbours_, i) > 1; }));
}

}  // namespace restenosis

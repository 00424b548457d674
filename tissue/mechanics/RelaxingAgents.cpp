#include "RelaxingAgents.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "Chunks.h"

namespace restenosis {
namespace {

// A disturbance of more agents than this share is no local one: it reaches everybody, and sleepers would only
// hold the others back, being woken layer by layer.
constexpr double localShare = 0.5;
// A disturbance of fewer is local however small the tissue.
constexpr std::size_t localCount = 500;

// Sleepers beside moving agents wake above this many times the tolerance, the others when all are checked in
// double precision. It is above what mixed precision errs by, so that an agent that is merely listed, its
// force unchanged, never wakes: who wakes must not depend on the list.
constexpr double wakingShare = 1.1;

// Where no more than this share of the awake agents is restless, the others may sleep ...
constexpr double fewRestless = 0.3;
// ... if they have come to rest to this share of what counts as settled ...
constexpr double restingShare = 0.5;
// ... and are farther than this many contacts from the restless, who need surroundings that give way.
constexpr int shellsKept = 4;

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
                               double softest, double tolerance, NeighbourList& neighbours, double skin,
                               std::optional<FixedScale> scale)
    : agents_(agents),
      bonds_(bonds),
      constraints_(constraints),
      field_(field),
      softest_(softest),
      tolerance_(tolerance),
      neighbours_(neighbours),
      range_(field.range(skin)),
      scale_(scale),
      force_(agents.size(), Vec3::Zero()),
      stiffness_(agents.size(), softest),
      residual_(agents.size(), 0.0),
      velocity_(agents.size(), Vec3::Zero()),
      isAwake_(agents.size(), 0),
      unsure_(agents.size(), 1),
      marked_(agents.size(), 0) {
  requireSound(agents, bonds);
  for (Index i = 0; i < agents.size(); ++i) {
    if (isFree(i)) free_.push_back(i);
  }
  if (scale_) {
    fixed_ = packSpheres(agents, *scale_);
  } else {
    spheres_ = packSpheres(agents);
  }
  if (!constraints_.empty()) {
    forEachInChunks(free_.size(),
                    [&](std::size_t k) { place(free_[k], projected(free_[k], agents_.position(free_[k]))); });
  }
  updatePairs();
  wakeAnyone();
}

void RelaxingAgents::updatePairs() {
  const NeighbourList::Change change = neighbours_.update(agents_, range_);
  const bool daughters = range_.daughterFactor > range_.factor;
  if (change.all || pairs_.size() != neighbours_.size()) {
    pairs_.build(neighbours_, bonds_, agents_.flags, daughters);
    std::ranges::fill(unsure_, 1);
    relisted_ = free_;
  } else {
    pairs_.update(neighbours_, bonds_, agents_.flags, daughters, change.agents);
    for (const Index i : change.agents) unsure_[i] = 1;
    relisted_.insert(relisted_.end(), change.agents.begin(), change.agents.end());
  }
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
  if (scale_) {
    fixed_[i] = scale_->of(position, agents_.radius[i]);
  } else {
    spheres_[i] = {position.x(), position.y(), position.z(), agents_.radius[i]};
  }
}

void RelaxingAgents::evaluate(std::span<const Index> subset) {
  if (scale_) {
    evaluate(FixedSpheres(fixed_, scale_->unit()), subset);
  } else {
    evaluate(ExactSpheres(spheres_), subset);
  }
}

void RelaxingAgents::evaluateExactly() {
  for (const Index i : moved_) {
    unsure_[i] = 1;
    for (const Index j : neighbours_.of(i)) unsure_[j] = 1;
    for (const Bond& bond : bonds_.of(i)) unsure_[bond.partner] = 1;
  }
  std::vector<Index> due;
  std::ranges::copy_if(free_, std::back_inserter(due), [&](Index i) { return unsure_[i] != 0; });
  if (scale_) {
    const std::vector<Sphere> spheres = packSpheres(agents_);
    evaluate(ExactSpheres(spheres), due);
  } else {
    evaluate(due);
  }
  std::ranges::fill(unsure_, 0);
  relisted_.clear();
  moved_ = awake_;
}

template <class Spheres>
void RelaxingAgents::evaluate(const Spheres& spheres, std::span<const Index> subset) {
  const auto bad = reducePieces<Any>(subset.size(), [&](std::size_t begin, std::size_t end, Any& part) {
    std::array<AgentLoad, chunkSize> loads;
    field_.evaluate(spheres, pairs_, subset.subspan(begin, end - begin), loads);
    for (std::size_t k = begin; k < end; ++k) {
      const Index i = subset[k];
      const AgentLoad& load = loads[k - begin];
      Vec3 force = load.force();
      for (const Constraint* constraint : constraints_) constraint->release(agents_, i, force);
      force_[i] = force;
      stiffness_[i] = std::max(softest_, load.stiffness);
      residual_[i] = force.norm();
      agents_.pressure[i] = load.pressure;
      if (!part.found && !std::isfinite(residual_[i])) part = {true, i};
    }
  });
  evaluations_ += subset.size();
  if (bad.found) {
    const Vec3& f = force_[bad.agent];
    throw std::runtime_error(fmt::format(
        "the force on agent {} at ({}, {}, {}) m is not finite: ({}, {}, {}) N", agents_.id[bad.agent],
        agents_.x[bad.agent], agents_.y[bad.agent], agents_.z[bad.agent], f.x(), f.y(), f.z()));
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
  if (far.found) updatePairs();
  evaluate(awake_);
}

bool RelaxingAgents::wakeDisturbed() {
  if (awake_.size() == free_.size()) {
    relisted_.clear();
    return false;
  }
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
  // Those whom an awake agent has left since they were looked at, too.
  for (const Index i : relisted_) consider(i);
  relisted_.clear();
  for (const Index j : beside) {
    marked_[j] = 0;
    unsure_[j] = 1;
  }
  std::ranges::sort(beside);
  evaluate(beside);
  std::erase_if(beside, [&](Index j) { return residual_[j] <= wakingShare * tolerance_; });
  wakeAround(beside);
  return !beside.empty();
}

bool RelaxingAgents::wakeAnyone() {
  evaluateExactly();
  std::vector<Index> restless;
  std::ranges::copy_if(free_, std::back_inserter(restless),
                       [&](Index i) { return !isAwake_[i] && residual_[i] > tolerance_; });
  wakeAround(restless);
  return awakeResidual() > tolerance_;
}

template <class Wanted>
std::vector<Index> RelaxingAgents::markPartners(const std::vector<Index>& agents, Wanted&& wanted) {
  std::vector<Index> partners;
  const auto consider = [&](Index j) {
    if (marked_[j] || !wanted(j)) return;
    marked_[j] = 1;
    partners.push_back(j);
  };
  for (const Index i : agents) {
    // Those that touch, not all listed: who wakes must not depend on the list.
    for (const Index j : neighbours_.of(i)) {
      const double radii = agents_.radius[i] + agents_.radius[j];
      if ((agents_.position(i) - agents_.position(j)).squaredNorm() < radii * radii) consider(j);
    }
    for (const Bond& bond : bonds_.of(i)) consider(bond.partner);
  }
  return partners;
}

void RelaxingAgents::wakeAround(const std::vector<Index>& restless) {
  wake(restless);
  std::vector<Index> sleepers = markPartners(restless, [this](Index j) { return !isAwake_[j] && isFree(j); });
  for (const Index j : sleepers) marked_[j] = 0;
  std::ranges::sort(sleepers);
  wake(sleepers);
  const auto local = static_cast<std::size_t>(localShare * static_cast<double>(free_.size()));
  if (awake_.size() > std::max(localCount, local)) {
    std::vector<Index> rest;
    std::ranges::copy_if(free_, std::back_inserter(rest), [&](Index i) { return !isAwake_[i]; });
    wake(rest);
    std::ranges::copy(rest, std::back_inserter(sleepers));
    std::ranges::sort(sleepers);
  }
  evaluate(sleepers);  // they set out with the forces of now, not of when they were last looked at
}

void RelaxingAgents::retireQuiet(double settled) {
  std::vector<Index> kept;
  std::ranges::copy_if(awake_, std::back_inserter(kept), [&](Index i) { return residual_[i] > settled; });
  if (static_cast<double>(kept.size()) > fewRestless * static_cast<double>(awake_.size())) return;
  for (const Index i : kept) marked_[i] = 1;
  std::vector<Index> shell = kept;
  for (int n = 0; n < shellsKept; ++n) {
    shell = markPartners(shell, [this](Index j) { return isAwake_[j] != 0; });
    kept.insert(kept.end(), shell.begin(), shell.end());
  }
  for (const Index i : awake_) {
    isAwake_[i] = marked_[i] || residual_[i] > restingShare * settled;
    if (!isAwake_[i]) velocity_[i].setZero();
  }
  for (const Index i : kept) marked_[i] = 0;
  std::erase_if(awake_, [&](Index i) { return !isAwake_[i]; });
}

void RelaxingAgents::wake(const std::vector<Index>& sleepers) {
  for (const Index i : sleepers) isAwake_[i] = 1;
  moved_.insert(moved_.end(), sleepers.begin(), sleepers.end());
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

}  // namespace restenosis

#include "AgentForces.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <stdexcept>

#include "Chunks.h"
#include "Room.h"

namespace restenosis {
namespace {

struct Any {
  bool found = false;
  Index agent = 0;
  void join(const Any& other) {
    if (!found && other.found) *this = other;
  }
};

void requireSound(const AgentStore& agents, const BondTable& bonds) {
  if (bonds.size() != agents.size()) {
    throw std::invalid_argument(
        fmt::format("the bond table has room for {} agents, there are {}: call BondTable::resize",
                    bonds.size(), agents.size()));
  }
  const auto bad = reduceInChunks<Any>(agents.size(), [&](std::size_t i, Any& part) {
    if (!part.found && !(agents.radius[i] > 0 && std::isfinite(agents.radius[i])))
      part = {true, static_cast<Index>(i)};
  });
  if (!bad.found) return;
  throw std::invalid_argument(fmt::format("agent {} has the radius {} m; radii are finite and above 0",
                                          agents.id[bad.agent], agents.radius[bad.agent]));
}

// Of a distance: farther apart no rounding can make a pair act.
constexpr double beyondRounding = 1 + 1e-6;

/// Lets `values` hold `count` elements, the new ones `value`.
template <class T>
void lengthen(std::vector<T>& values, std::size_t count, const T& value) {
  makeRoom(values, count);
  values.resize(count, value);
}

}  // namespace

AgentForces::AgentForces(AgentStore& agents, const BondTable& bonds,
                         std::span<const Constraint* const> constraints, const ForceField& field,
                         NeighbourList& neighbours, const Settings& settings)
    : agents_(agents),
      bonds_(bonds),
      constraints_(constraints.begin(), constraints.end()),
      field_(field),
      neighbours_(neighbours),
      settings_(settings),
      range_(field.range(settings.skin)) {
  requireSound(agents_, bonds_);
  start();
}

void AgentForces::start() {
  const std::size_t count = agents_.size();
  motion_.assign(count, AgentMotion{.stiffness = settings_.softest});
  unsure_.assign(count, 1);
  moving_.clear();
  isMoving_.assign(count, 0);
  free_ = agentsThat(count, [this](Index i) { return isFree(i); });
  scale_ = settings_.scale;
  if (scale_ && !agentsThat(count, [this](Index i) { return !fits(i); }).empty()) scale_.reset();
  // Without mixed precision although it was asked for, everything is looked at again the next time.
  outgrown_ = scale_.has_value() != settings_.scale.has_value();
  project();
  neighbours_.update(agents_, range_);
  buildPairs();
}

void AgentForces::refresh() {
  requireSound(agents_, bonds_);
  if (outgrown_ || !neighbours_.sameAgents(agents_)) return start();
  project();
  const Index known = neighbours_.size();
  const std::size_t count = agents_.size();
  lengthen(motion_, count, AgentMotion{.stiffness = settings_.softest});
  lengthen(unsure_, count, std::uint8_t{1});
  lengthen(isMoving_, count, std::uint8_t{0});

  std::vector<Index> others = agentsThat(known, [this](Index i) { return changed(i); });
  doubtAround(others);
  for (Index i = known; i < count; ++i) {
    others.push_back(i);
    if (isFree(i)) free_.push_back(i);
  }
  if (scale_ && !allFit(others)) return start();

  const NeighbourList::Change change = neighbours_.update(agents_, range_);
  if (change.all || count > pairs_.nobody()) {
    buildPairs();
    if (change.all) std::ranges::fill(unsure_, 1);
  } else {
    for (const Index i : others) take(i);
    pairs_.update(neighbours_, bonds_, agents_.flags, marksDaughters(), change.agents);
  }
  doubtAround(others);
  for (const Index i : moving_) isMoving_[i] = 0;
  moving_.clear();
}

bool AgentForces::isFree(Index i) const {
  return !agents_.has(i, AgentFlag::fixed) && agents_.kind[i] != AgentKind::strut;
}

bool AgentForces::fits(Index i) const {
  const double within = scale_->reach() / 4;
  return agents_.radius[i] <= within && std::ranges::all_of(bonds_.of(i), [&](const Bond& bond) {
           return (agents_.position(i) - agents_.position(bond.partner)).squaredNorm() <= within * within;
         });
}

bool AgentForces::allFit(std::span<const Index> agents) const {
  return agentsOf(agents, [this](Index i) { return !fits(i); }).empty();
}

bool AgentForces::changed(Index i) const {
  const Sphere& s = spheres_[i];
  return s.x != agents_.x[i] || s.y != agents_.y[i] || s.z != agents_.z[i] || s.r != agents_.radius[i];
}

void AgentForces::take(Index i) {
  spheres_[i] = {agents_.x[i], agents_.y[i], agents_.z[i], agents_.radius[i]};
  if (scale_) fixed_[i] = scale_->of(agents_.position(i), agents_.radius[i]);
}

void AgentForces::packAll() {
  spheres_ = packSpheres(agents_, pairs_.nobody());
  if (scale_) fixed_ = packSpheres(agents_, pairs_.nobody(), *scale_);
}

void AgentForces::buildPairs() {
  pairs_.build(neighbours_, bonds_, agents_.flags, marksDaughters());
  packAll();
}

bool AgentForces::mayAct(Index i, const Vec3& position, double radius, Index j) const {
  const double sum = radius + std::max(spheres_[j].r, agents_.radius[j]);
  const bool daughter = ((agents_.flags[i] | agents_.flags[j]) & AgentFlag::daughter) != 0;
  const double reach = beyondRounding * (daughter ? range_.daughterFactor : range_.factor) * sum;
  return (position - agents_.position(j)).squaredNorm() < reach * reach;
}

bool AgentForces::mayHaveActed(Index i, Index j) const {
  // Without mixed precision it is not known where the agent was.
  const Sphere& before = spheres_[i];
  return !scale_ || mayAct(i, Vec3(before.x, before.y, before.z), before.r, j) ||
         mayAct(i, agents_.position(i), agents_.radius[i], j);
}

void AgentForces::doubtAround(std::span<const Index> agents) {
  forEachInChunks(agents.size(), [&](std::size_t k) {
    const Index i = agents[k];
    const auto doubtOne = [this](Index j) {
      std::atomic_ref(unsure_[j]).store(1, std::memory_order_relaxed);
    };
    doubtOne(i);
    for (const Index j : neighbours_.of(i)) {
      if (mayHaveActed(i, j)) doubtOne(j);
    }
    for (const Bond& bond : bonds_.of(i)) doubtOne(bond.partner);
  });
}

void AgentForces::project() {
  if (constraints_.empty()) return;
  forEachInChunks(agents_.size(), [&](std::size_t k) {
    const auto i = static_cast<Index>(k);
    if (!isFree(i)) return;
    Vec3 position = agents_.position(i);
    for (const Constraint* constraint : constraints_) constraint->project(agents_, i, position);
    agents_.setPosition(i, position);
  });
}

bool AgentForces::moveTo(Index i, const Vec3& position) {
  Vec3 place = position;
  for (const Constraint* constraint : constraints_) constraint->project(agents_, i, place);
  agents_.setPosition(i, place);
  if (scale_) {
    fixed_[i] = scale_->of(place, agents_.radius[i]);
  } else {
    spheres_[i] = {place.x(), place.y(), place.z(), agents_.radius[i]};
  }
  return neighbours_.movedTooFar(i, place);
}

void AgentForces::updateLists(std::span<const Index> moved, std::vector<Index>& relisted) {
  const NeighbourList::Change change = neighbours_.update(agents_, moved);
  if (change.all) {
    buildPairs();
    std::ranges::fill(unsure_, 1);
    relisted = free_;
  } else {
    pairs_.update(neighbours_, bonds_, agents_.flags, marksDaughters(), change.agents);
    doubt(change.agents);
    relisted.insert(relisted.end(), change.agents.begin(), change.agents.end());
  }
}

void AgentForces::startMoving(std::span<const Index> agents) {
  for (const Index i : agents) {
    if (!isMoving_[i]) moving_.push_back(i);
    isMoving_[i] = 1;
  }
}

void AgentForces::doubt(std::span<const Index> agents) {
  for (const Index i : agents) unsure_[i] = 1;
}

void AgentForces::evaluate(std::span<const Index> subset, const Look& look) {
  if (scale_) {
    evaluate(FixedSpheres(fixed_, scale_->unit()), subset, look);
  } else {
    evaluate(ExactSpheres(spheres_), subset, look);
  }
}

std::vector<Index> AgentForces::evaluateExactly(std::span<const Index> moving) {
  doubtAround(moving_);
  for (const Index i : moving_) spheres_[i] = {agents_.x[i], agents_.y[i], agents_.z[i], agents_.radius[i]};
  outgrown_ = outgrown_ || (scale_ && !allFit(moving_));
  std::vector<Index> due = agentsOf(free_, [this](Index i) { return unsure_[i] != 0; });
  evaluate(ExactSpheres(spheres_), due, {});
  std::ranges::fill(unsure_, 0);
  for (const Index i : moving_) isMoving_[i] = 0;
  moving_.clear();
  startMoving(moving);
  return due;
}

template <class Spheres>
void AgentForces::evaluate(const Spheres& spheres, std::span<const Index> subset, const Look& look) {
  const auto bad = reducePieces<Any>(subset.size(), [&](std::size_t begin, std::size_t end, Any& part) {
    std::array<AgentLoad, chunkSize> loads;
    field_.evaluate(spheres, pairs_, subset.subspan(begin, end - begin), loads);
    for (std::size_t k = begin; k < end; ++k) {
      const Index i = subset[k];
      const AgentLoad& load = loads[k - begin];
      Vec3 force = load.force();
      for (const Constraint* constraint : constraints_) constraint->release(agents_, i, force);
      AgentMotion& motion = motion_[i];
      motion.force = force;
      motion.stiffness = std::max(settings_.softest, load.stiffness);
      motion.restlessness = force.norm();
      if (agents_.has(i, AgentFlag::daughter)) {
        const double held = std::max(settings_.softest, load.firmness);
        motion.restlessness *= std::max(1.0, settings_.firm / held);
      }
      agents_.pressure[i] = load.pressure;
      if (!part.found && !std::isfinite(motion.restlessness)) part = {true, i};
    }
    if (look) look(begin, end);
  });
  evaluations_ += subset.size();
  if (bad.found) {
    const Vec3& f = motion_[bad.agent].force;
    throw std::runtime_error(fmt::format(
        "the force on agent {} at ({}, {}, {}) m is not finite: ({}, {}, {}) N", agents_.id[bad.agent],
        agents_.x[bad.agent], agents_.y[bad.agent], agents_.z[bad.agent], f.x(), f.y(), f.z()));
  }
}

}  // namespace restenosis

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
  Vec3 force = Vec3::Zero();
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

// Of what is added to a leash and of what is taken off it: single precision errs by less.
constexpr double shorter = 1 - 1e-5, longer = 1 + 1e-5;

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
  residual_.assign(count, 0);
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
  lengthen(residual_, count, 0.0);
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
    for (const Constraint* constraint : constraints_)
      constraint->project(agents_.kind[i], agents_.radius[i], position);
    agents_.setPosition(i, position);
  });
}

AgentMotion AgentForces::motionOf(Index i) const {
  const Vec3 position = agents_.position(i);
  return {.position = position,
          .now = {},
          .radius = agents_.radius[i],
          .leash = leashOf(i, position),
          .kind = agents_.kind[i],
          .daughter = agents_.has(i, AgentFlag::daughter)};
}

float AgentForces::leashOf(Index i, const Vec3& position) const {
  return static_cast<float>(shorter * neighbours_.room(i, position));
}

bool AgentForces::moveTo(Index i, AgentMotion& agent, const Vec3& position) {
  Vec3 place = position;
  for (const Constraint* constraint : constraints_) constraint->project(agent.kind, agent.radius, place);
  agent.leash -= static_cast<float>(longer * (place - agent.position).norm());
  agent.position = place;
  if (scale_) {
    fixed_[i] = scale_->of(place, agent.radius);
  } else {
    spheres_[i] = {place.x(), place.y(), place.z(), agent.radius};
  }
  if (agent.leash >= 0) return false;
  agent.leash = leashOf(i, place);
  return !(agent.leash >= 0);
}

void AgentForces::updateLists(MovingAgents& moving, std::vector<Index>& relisted) {
  const double comfortable = neighbours_.comfortableRoom();
  const auto hasRoom = [&](std::size_t k) {
    float& leash = moving.motion[k].leash;
    if (leash > comfortable) return true;
    leash = leashOf(moving.agents[k], moving.motion[k].position);
    return leash > comfortable;
  };
  const std::vector<Index> places = agentsThat(moving.size(), [&](Index k) { return !hasRoom(k); });
  std::vector<Index> moved;
  for (const Index k : places) {
    place(moving.agents[k], moving.motion[k]);
    moved.push_back(moving.agents[k]);
  }
  if (!neighbours_.worthLookingUp(moved.size())) placeAll(moving);  // it is built anew from all
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

AgentForce AgentForces::forceOn(const AgentLoad& load, AgentKind kind, bool daughter, double radius,
                                const Vec3& position) const {
  AgentForce on{.force = load.force(), .stiffness = std::max(settings_.softest, load.stiffness)};
  for (const Constraint* constraint : constraints_) constraint->release(kind, radius, position, on.force);
  on.restlessness = on.force.norm();
  if (daughter) {
    const double held = std::max(settings_.softest, load.firmness);
    on.restlessness *= std::max(1.0, settings_.firm / held);
  }
  return on;
}

template <class F>
void AgentForces::withSpheres(F&& f) const {
  if (scale_) {
    f(FixedSpheres(fixed_, scale_->unit()));
  } else {
    f(ExactSpheres(spheres_));
  }
}

template <class Spheres, class Set, class Seen>
void AgentForces::evaluate(const Spheres& spheres, std::span<const Index> subset, const Set& set,
                           const Seen& look) {
  const auto bad = reducePieces<Any>(subset.size(), [&](std::size_t begin, std::size_t end, Any& part) {
    std::array<AgentLoad, chunkSize> loads;
    field_.evaluate(spheres, pairs_, subset.subspan(begin, end - begin), loads);
    for (std::size_t k = begin; k < end; ++k) {
      const AgentForce& on = set(k, loads[k - begin]);
      if (!part.found && !std::isfinite(on.restlessness)) part = {true, subset[k], on.force};
    }
    look(begin, end);
  });
  evaluations_ += subset.size();
  if (!bad.found) return;
  const Vec3& f = bad.force;
  throw std::runtime_error(fmt::format(
      "the force on agent {} near ({}, {}, {}) m is not finite: ({}, {}, {}) N", agents_.id[bad.agent],
      agents_.x[bad.agent], agents_.y[bad.agent], agents_.z[bad.agent], f.x(), f.y(), f.z()));
}

template <class Spheres>
void AgentForces::evaluateResting(const Spheres& spheres, std::span<const Index> subset, const Take& take) {
  const auto set = [&](std::size_t k, const AgentLoad& load) {
    const Index i = subset[k];
    const AgentForce on = forceOn(load, agents_.kind[i], agents_.has(i, AgentFlag::daughter),
                                  agents_.radius[i], agents_.position(i));
    agents_.pressure[i] = load.pressure;
    take(k, i, on);
    return on;
  };
  evaluate(spheres, subset, set, [](std::size_t, std::size_t) {});
}

void AgentForces::evaluate(MovingAgents& moving, const Look& look) {
  const auto set = [&](std::size_t k, const AgentLoad& load) -> const AgentForce& {
    AgentMotion& agent = moving.motion[k];
    return agent.now = forceOn(load, agent.kind, agent.daughter, agent.radius, agent.position);
  };
  withSpheres([&](const auto& spheres) { evaluate(spheres, moving.agents, set, look); });
}

void AgentForces::evaluate(std::span<const Index> resting, const Take& take) {
  withSpheres([&](const auto& spheres) { evaluateResting(spheres, resting, take); });
}

void AgentForces::placeAll(const MovingAgents& moving) {
  forEachInChunks(moving.size(), [&](std::size_t k) { place(moving.agents[k], moving.motion[k]); });
}

std::vector<Index> AgentForces::unsure(const MovingAgents& moving) {
  placeAll(moving);
  doubtAround(moving_);
  for (const Index i : moving_) spheres_[i] = {agents_.x[i], agents_.y[i], agents_.z[i], agents_.radius[i]};
  outgrown_ = outgrown_ || (scale_ && !allFit(moving_));
  return agentsOf(free_, [this](Index i) { return unsure_[i] != 0; });
}

void AgentForces::evaluateExactly(std::span<const Index> unsure, std::span<const Index> moving,
                                  const Take& take) {
  evaluateResting(ExactSpheres(spheres_), unsure, [&](std::size_t k, Index i, const AgentForce& on) {
    residual_[i] = on.force.norm();
    take(k, i, on);
  });
  std::ranges::fill(unsure_, 0);
  for (const Index i : moving_) isMoving_[i] = 0;
  moving_.clear();
  startMoving(moving);
}

}  // namespace restenosis

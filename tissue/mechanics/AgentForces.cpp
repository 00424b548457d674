#include "AgentForces.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
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

static_assert(PairRows::most == chunkSize);

// Of what is added to a leash and of what is taken off it: single precision errs by less.
constexpr double shorter = 1 - 1e-5;
constexpr float longer = 1 + 1e-5F;

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
      range_(field.range(settings.skin)),
      spheres_(agents, bonds, settings.scale),
      unsure_(agents, bonds, neighbours, spheres_, range_) {
  requireSound(agents_, bonds_);
  start();
}

void AgentForces::start() {
  const std::size_t count = agents_.size();
  residual_.assign(count, 0);
  unsure_.start(count);
  free_ = agentsThat(count, [this](Index i) { return isFree(i); });
  spheres_.choosePrecision();
  project();
  neighbours_.update(agents_, range_);
  spheres_.packAll();
}

void AgentForces::refresh() {
  requireSound(agents_, bonds_);
  if (spheres_.outgrown() || !neighbours_.sameAgents(agents_)) return start();
  project();
  const Index known = neighbours_.size();
  const std::size_t count = agents_.size();
  makeRoom(residual_, count);
  residual_.resize(count, 0);
  unsure_.append(count);

  std::vector<Index> others = agentsThat(known, [this](Index i) { return spheres_.changed(i); });
  unsure_.markAround(others);
  for (Index i = known; i < count; ++i) {
    others.push_back(i);
    if (isFree(i)) free_.push_back(i);
  }
  if (!spheres_.fit(others)) return start();

  const NeighbourList::Change change = neighbours_.update(agents_, range_);
  if (change.all) unsure_.mark();
  if (count > spheres_.nobody()) {
    spheres_.packAll();
  } else {
    for (const Index i : others) spheres_.copy(i);
  }
  unsure_.markAround(others);
  unsure_.stopMoving();
}

bool AgentForces::isFree(Index i) const {
  return !agents_.has(i, AgentFlag::fixed) && agents_.kind[i] != AgentKind::strut;
}

PairSource AgentForces::pairs() const {
  return {neighbours_, bonds_, agents_.flags, range_.daughterFactor > range_.factor};
}

void AgentForces::layOut(MovingAgents& moving) const {
  const std::span<const Index> agents(moving.agents);
  moving.rows.resize((agents.size() + PairRows::most - 1) / PairRows::most);
  forEachPiece(agents.size(), [&](std::size_t begin, std::size_t end) {
    moving.rows[begin / PairRows::most].layOut(pairs(), agents.subspan(begin, end - begin),
                                               spheres_.nobody());
  });
  moving.areRowsOf = true;
}

void AgentForces::layOutAnew(MovingAgents& moving, std::span<const Index> changed) const {
  if (!moving.areRowsOf) return;
  const PairSource source = pairs();
  forEachPiece(moving.size(), [&](std::size_t begin, std::size_t end) {
    const auto agents = std::span<const Index>(moving.agents).subspan(begin, end - begin);
    PairRows& rows = moving.rows[begin / PairRows::most];
    auto agent = agents.begin();
    for (auto i = std::ranges::lower_bound(changed, agents.front());
         i != changed.end() && *i <= agents.back(); ++i) {
      agent = std::lower_bound(agent, agents.end(), *i);
      if (*agent != *i) continue;
      if (rows.replace(source, static_cast<std::size_t>(agent - agents.begin()), *i)) continue;
      rows.layOut(source, agents, spheres_.nobody());
      break;
    }
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
  const float step = longer * std::sqrt(static_cast<float>((place - agent.position).squaredNorm()));
  agent.leash -= step;
  agent.way += step;
  agent.position = place;
  spheres_.moveTo(i, place, agent.radius);
  const double comfortable = neighbours_.comfortableRoom();
  if (agent.leash > comfortable) return false;
  agent.leash = leashOf(i, place);
  return !(agent.leash > comfortable);
}

bool AgentForces::inRange(const AgentMotion& agent, Index j) const {
  const bool daughter = agent.daughter || agents_.has(j, AgentFlag::daughter);
  const double reach =
      (daughter ? range_.daughterFactor : range_.factor) * (agent.radius + agents_.radius[j]);
  return (agent.position - agents_.position(j)).squaredNorm() < reach * reach;
}

void AgentForces::updateLists(MovingAgents& moving, std::span<const Index> cramped) {
  if (std::ranges::all_of(cramped, [&](Index k) { return moving.motion[k].leash >= 0; })) return;
  std::vector<Index> moved;
  for (const Index k : cramped) {
    place(moving.agents[k], moving.motion[k]);
    moved.push_back(moving.agents[k]);
  }
  if (!neighbours_.worthLookingUp(moved.size())) placeAll(moving);  // it is built anew from all
  const NeighbourList::Change change = neighbours_.update(agents_, moved);
  if (change.all) {
    moving.areRowsOf = false;
    unsure_.mark();
  } else {
    layOutAnew(moving, change.agents);
    unsure_.mark(change.agents);
  }
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

template <class Spheres>
void AgentForces::evaluateOnce(const Spheres& spheres, std::span<const Index> piece,
                               std::span<AgentLoad> loads) const {
  thread_local PairRows rows;
  rows.layOut(pairs(), piece, spheres_.nobody());
  field_.evaluate(spheres, rows, piece, loads);
}

template <class LoadsOf, class Set, class Seen>
void AgentForces::evaluate(std::span<const Index> agents, const LoadsOf& loadsOf, const Set& set,
                           const Seen& look) {
  const auto bad = reducePieces<Any>(agents.size(), [&](std::size_t begin, std::size_t end, Any& part) {
    std::array<AgentLoad, chunkSize> loads;
    loadsOf(begin, end, loads);
    for (std::size_t k = begin; k < end; ++k) {
      const AgentForce& on = set(k, loads[k - begin]);
      if (!part.found && !std::isfinite(on.restlessness)) part = {true, agents[k], on.force};
    }
    look(begin, end);
  });
  evaluations_ += agents.size();
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
  const auto loadsOf = [&](std::size_t begin, std::size_t end, std::span<AgentLoad> loads) {
    evaluateOnce(spheres, subset.subspan(begin, end - begin), loads);
  };
  evaluate(subset, loadsOf, set, [](std::size_t, std::size_t) {});
}

void AgentForces::evaluate(MovingAgents& moving, const Look& look) {
  if (!moving.areRowsOf) layOut(moving);
  const auto set = [&](std::size_t k, const AgentLoad& load) -> const AgentForce& {
    AgentMotion& agent = moving.motion[k];
    return agent.now = forceOn(load, agent.kind, agent.daughter, agent.radius, agent.position);
  };
  spheres_.withPresent([&](const auto& spheres) {
    const auto loadsOf = [&](std::size_t begin, std::size_t end, std::span<AgentLoad> loads) {
      const auto piece = std::span<const Index>(moving.agents).subspan(begin, end - begin);
      field_.evaluate(spheres, moving.rows[begin / PairRows::most], piece, loads);
    };
    evaluate(moving.agents, loadsOf, set, look);
  });
}

void AgentForces::evaluate(std::span<const Index> resting, const Take& take) {
  spheres_.withPresent([&](const auto& spheres) { evaluateResting(spheres, resting, take); });
}

void AgentForces::placeAll(const MovingAgents& moving) {
  forEachInChunks(moving.size(), [&](std::size_t k) { place(moving.agents[k], moving.motion[k]); });
}

std::vector<Index> AgentForces::unsure(const MovingAgents& moving) {
  placeAll(moving);
  unsure_.markAroundMoving();
  spheres_.remember(unsure_.moving());
  return agentsOf(free_, [this](Index i) { return unsure_.marked(i); });
}

void AgentForces::pressHeld() {
  const std::vector<Index> held = agentsThat(size(), [this](Index i) {
    return unsure_.marked(i) && agents_.has(i, AgentFlag::fixed) && agents_.kind[i] != AgentKind::strut;
  });
  forEachPiece(held.size(), [&](std::size_t begin, std::size_t end) {
    std::array<AgentLoad, chunkSize> loads;
    evaluateOnce(spheres_.exact(), std::span<const Index>(held).subspan(begin, end - begin), loads);
    for (std::size_t k = begin; k < end; ++k) agents_.pressure[held[k]] = loads[k - begin].pressure;
  });
  evaluations_ += held.size();
}

void AgentForces::evaluateExactly(std::span<const Index> unsure, std::span<const Index> moving,
                                  const Take& take) {
  evaluateResting(spheres_.exact(), unsure, [&](std::size_t k, Index i, const AgentForce& on) {
    residual_[i] = on.force.norm();
    take(k, i, on);
  });
  pressHeld();
  unsure_.know();
  unsure_.stopMoving();
  unsure_.startMoving(moving);
}

}  // namespace restenosis

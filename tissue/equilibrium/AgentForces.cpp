#include "tissue/equilibrium/AgentForces.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "tissue/agents/Chunks.h"
#include "tissue/agents/Room.h"

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

static_assert(PairRows::most == chunkSize && MotionPiece::most == chunkSize);

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
  forEachInChunks(count, [&](std::size_t k) { project(static_cast<Index>(k)); });
  neighbours_.update(agents_, range_);
  spheres_.packAll();
}

void AgentForces::refresh() {
  requireSound(agents_, bonds_);
  if (spheres_.outgrown() || !neighbours_.sameAgents(agents_)) return start();
  const Index known = neighbours_.size();
  const std::size_t count = agents_.size();
  makeRoom(residual_, count);
  residual_.resize(count, 0);
  unsure_.append(count);

  // Both at once, for either takes as long as reading where all agents are
  std::vector<Index> others = agentsThat(known, [this](Index i) {
    project(i);
    return spheres_.changed(i);
  });
  for (Index i = known; i < count; ++i) project(i);
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

void AgentForces::project(Index i) {
  if (!isFree(i)) return;
  const Vec3 before = agents_.position(i);
  if (roomOf(agents_.kind[i], agents_.radius[i], before) > 0) return;
  Vec3 position = before;
  for (const Constraint* constraint : constraints_)
    constraint->project(agents_.kind[i], agents_.radius[i], position);
  if (position != before) agents_.setPosition(i, position);
}

AgentMotion AgentForces::motionOf(Index i) const {
  const Vec3 position = agents_.position(i);
  return {.position = position,
          .radius = agents_.radius[i],
          .leash = leashOf(i, position),
          .room = roomOf(agents_.kind[i], agents_.radius[i], position),
          .kind = agents_.kind[i],
          .daughter = agents_.has(i, AgentFlag::daughter)};
}

float AgentForces::leashOf(Index i, const Vec3& position) const {
  return static_cast<float>(shorter * neighbours_.room(i, position));
}

float AgentForces::roomOf(AgentKind kind, double radius, const Vec3& position) const {
  double least = std::numeric_limits<double>::infinity();
  for (const Constraint* constraint : constraints_)
    least = std::min(least, constraint->room(kind, radius, position));
  return static_cast<float>(shorter * least);
}

void AgentForces::move(std::span<const Index> agents, MotionPiece& piece, const Moves& moves,
                       std::vector<Index>& cramped) {
  struct {
    MotionPiece::Doubles x, y, z;
  } to;
  for (std::size_t k = 0; k < agents.size(); ++k) {
    to.x[k] = piece.x[k] + static_cast<double>(moves.x[k]);
    to.y[k] = piece.y[k] + static_cast<double>(moves.y[k]);
    to.z[k] = piece.z[k] + static_cast<double>(moves.z[k]);
  }
  for (std::size_t k = 0; k < agents.size(); ++k) {
    const float dx = moves.x[k], dy = moves.y[k], dz = moves.z[k];
    piece.room[k] -= longer * std::sqrt(dx * dx + dy * dy + dz * dz);
  }
  for (std::size_t k = 0; k < agents.size(); ++k) {
    if (piece.room[k] > 0) continue;
    Vec3 place(to.x[k], to.y[k], to.z[k]);
    for (const Constraint* constraint : constraints_)
      constraint->project(piece.kind[k], piece.radius[k], place);
    to.x[k] = place.x(), to.y[k] = place.y(), to.z[k] = place.z();
    piece.room[k] = roomOf(piece.kind[k], piece.radius[k], place);
  }
  for (std::size_t k = 0; k < agents.size(); ++k) {
    const double dx = to.x[k] - piece.x[k], dy = to.y[k] - piece.y[k], dz = to.z[k] - piece.z[k];
    const float step = longer * std::sqrt(static_cast<float>(dx * dx + dy * dy + dz * dz));
    piece.leash[k] -= step;
    piece.way[k] += step;
    piece.x[k] = to.x[k], piece.y[k] = to.y[k], piece.z[k] = to.z[k];
  }
  const auto comfortable = static_cast<float>(neighbours_.comfortableRoom());
  for (std::size_t k = 0; k < agents.size(); ++k) {
    spheres_.moveTo(agents[k], piece.position(k), piece.radius[k]);
    if (piece.leash[k] > comfortable) continue;
    piece.leash[k] = leashOf(agents[k], piece.position(k));
    if (!(piece.leash[k] > comfortable)) cramped.push_back(static_cast<Index>(k));
  }
}

bool AgentForces::inRange(const MotionPiece& piece, std::size_t k, Index j) const {
  const bool daughter = piece.daughter[k] || agents_.has(j, AgentFlag::daughter);
  const double reach =
      (daughter ? range_.daughterFactor : range_.factor) * (piece.radius[k] + agents_.radius[j]);
  return (piece.position(k) - agents_.position(j)).squaredNorm() < reach * reach;
}

void AgentForces::updateLists(MovingAgents& moving, std::span<const Index> cramped) {
  const auto hasRoom = [&](Index k) { return moving.pieceOf(k).leash[moving.inPiece(k)] >= 0; };
  if (std::ranges::all_of(cramped, hasRoom)) return;
  std::vector<Index> moved;
  for (const Index k : cramped) {
    place(moving.agents[k], moving.position(k));
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

void AgentForces::setForces(MotionPiece& piece, std::span<const AgentLoad> loads) const {
  for (std::size_t k = 0; k < loads.size(); ++k) {
    piece.setForce(k, loads[k].force());
    piece.stiffness[k] = static_cast<float>(std::max(settings_.softest, loads[k].stiffness));
  }
  for (std::size_t k = 0; k < loads.size(); ++k) {
    if (piece.room[k] > 0) continue;
    Vec3 force = piece.force(k);
    for (const Constraint* constraint : constraints_)
      constraint->release(piece.kind[k], piece.radius[k], piece.position(k), force);
    piece.setForce(k, force);
  }
  for (std::size_t k = 0; k < loads.size(); ++k) {
    const float squared = piece.fx[k] * piece.fx[k] + piece.fy[k] * piece.fy[k] + piece.fz[k] * piece.fz[k];
    piece.residual[k] = std::sqrt(squared) / (piece.stiffness[k] * piece.radius[k]);
  }
}

template <class Spheres>
void AgentForces::evaluateOnce(const Spheres& spheres, std::span<const Index> piece,
                               std::span<AgentLoad> loads) const {
  thread_local PairRows rows;
  rows.layOut(pairs(), piece, spheres_.nobody());
  field_.evaluate(spheres, rows, piece, loads);
}

template <class LoadsOf, class Set>
void AgentForces::evaluatePieces(std::span<const Index> agents, const LoadsOf& loadsOf, const Set& set) {
  const auto bad = reducePieces<Any>(agents.size(), [&](std::size_t begin, std::size_t end, Any& part) {
    std::array<AgentLoad, chunkSize> loads;
    const auto ofPiece = std::span(loads).first(end - begin);
    loadsOf(begin, ofPiece);
    const MotionPiece& piece = set(begin, ofPiece);
    for (std::size_t k = 0; k < ofPiece.size(); ++k)
      if (!part.found && !std::isfinite(piece.residual[k])) part = {true, agents[begin + k], piece.force(k)};
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
  const auto loadsOf = [&](std::size_t begin, std::span<AgentLoad> loads) {
    evaluateOnce(spheres, subset.subspan(begin, loads.size()), loads);
  };
  const auto set = [&](std::size_t begin, std::span<const AgentLoad> loads) -> const MotionPiece& {
    thread_local MotionPiece piece;
    for (std::size_t k = 0; k < loads.size(); ++k) {
      const Index i = subset[begin + k];
      piece.x[k] = agents_.x[i], piece.y[k] = agents_.y[i], piece.z[k] = agents_.z[i];
      piece.radius[k] = static_cast<float>(agents_.radius[i]);
      piece.room[k] = 0;
      piece.kind[k] = agents_.kind[i], piece.daughter[k] = agents_.has(i, AgentFlag::daughter);
      agents_.pressure[i] = loads[k].pressure;
    }
    setForces(piece, loads);
    for (std::size_t k = 0; k < loads.size(); ++k) take(begin + k, subset[begin + k], piece.now(k));
    return piece;
  };
  evaluatePieces(subset, loadsOf, set);
}

void AgentForces::evaluate(MovingAgents& moving, const Look& look) {
  if (!moving.areRowsOf) layOut(moving);
  const auto set = [&](std::size_t begin, std::span<const AgentLoad> loads) -> const MotionPiece& {
    MotionPiece& piece = moving.pieceOf(begin);
    setForces(piece, loads);
    look(begin, begin + loads.size());
    return piece;
  };
  spheres_.withPresent([&](const auto& spheres) {
    const auto loadsOf = [&](std::size_t begin, std::span<AgentLoad> loads) {
      moving.pieceOf(begin).fetch();  // for setForces and `look`
      field_.evaluate(spheres, moving.rows[begin / PairRows::most], moving.agentsFrom(begin), loads);
    };
    evaluatePieces(moving.agents, loadsOf, set);
  });
}

void AgentForces::evaluate(std::span<const Index> resting, const Take& take) {
  spheres_.withPresent([&](const auto& spheres) { evaluateResting(spheres, resting, take); });
}

void AgentForces::placeAll(const MovingAgents& moving) {
  forEachInChunks(moving.size(), [&](std::size_t k) { place(moving.agents[k], moving.position(k)); });
}

std::vector<Index> AgentForces::unsure(const MovingAgents& moving) {
  placeAll(moving);
  unsure_.markAroundMoving();
  spheres_.remember(unsure_.moving());
  return unsure_.those([this](Index i) { return isFree(i); });
}

void AgentForces::pressHeld() {
  const std::vector<Index> held = unsure_.those(
      [this](Index i) { return agents_.has(i, AgentFlag::fixed) && agents_.kind[i] != AgentKind::strut; });
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
    residual_[i] = on.residual;
    take(k, i, on);
  });
  pressHeld();
  unsure_.know();
  unsure_.stopMoving();
  unsure_.startMoving(moving);
}

}  // namespace restenosis

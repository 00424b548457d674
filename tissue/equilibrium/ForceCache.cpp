#include "tissue/equilibrium/ForceCache.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "tissue/agents/Capacity.h"
#include "tissue/agents/Chunks.h"

namespace restenosis {
namespace {

static_assert(PairList::capacity == chunkSize && ActiveChunk::capacity == chunkSize);

// Of a distance: more than rounding can change it by.
constexpr float beyondRounding = 1 + 1e-6F;

/// The first agent that something is wrong with.
struct First {
  bool found = false;
  Index agent = 0;
  AgentForce force;
  void join(const First& other) {
    if (!found && other.found) *this = other;
  }
};

}  // namespace

ForceCache::ForceCache(AgentStore& agents, const BondTable& bonds, const Constraints& constraints,
                       const ForceField& field, NeighbourList& neighbours, const Settings& settings)
    : agents_(agents),
      bonds_(bonds),
      constraints_(constraints),
      field_(field),
      neighbours_(neighbours),
      settings_(settings),
      range_(field.range(settings.skin)),
      spheres_(agents, bonds, settings.mixed) {}

void ForceCache::requireSound() const {
  if (bonds_.size() != agents_.size()) {
    throw std::invalid_argument(
        fmt::format("the bond table is for {} agents, there are {}: call BondTable::resize", bonds_.size(),
                    agents_.size()));
  }
  const auto bad = reduceInChunks<First>(agents_.size(), [&](std::size_t i, First& part) {
    if (!part.found && !(agents_.radius[i] > 0 && std::isfinite(agents_.radius[i])))
      part = {true, static_cast<Index>(i), {}};
  });
  if (!bad.found) return;
  throw std::invalid_argument(fmt::format("agent {} has the radius {} m; radii are finite and above 0",
                                          agents_.id[bad.agent], agents_.radius[bad.agent]));
}

void ForceCache::refresh() {
  requireSound();
  const auto known = static_cast<Index>(residual_.size());
  if (!precisionHolds_ || !neighbours_.sameAgents(agents_)) return refreshAll();

  std::vector<Index> changed = agentsThat(known, [this](Index i) { return spheres_.changed(i); });
  const std::size_t knownChanged = changed.size();
  for (Index i = known; i < agents_.size(); ++i) changed.push_back(i);
  if (!spheres_.precisionHolds(changed)) return refreshAll();
  std::vector<double> slack(changed.size());
  forEachInChunks(knownChanged, [&](std::size_t k) {
    const AgentSpheres::Change change = spheres_.changeOf(changed[k]);
    slack[k] = change.distance + range_.largestFactor() * change.growth;
  });

  growCapacity(residual_, agents_.size());
  residual_.resize(agents_.size(), 0);
  stale_.resize(agents_.size());
  // By the former list, too: an agent that moved far is no longer listed for its former neighbours.
  forEachInChunks(knownChanged, [&](std::size_t k) { markAround(changed[k], slack[k]); });
  if (neighbours_.update(agents_, range_).all) stale_.markAll();
  if (agents_.size() > spheres_.none()) {
    spheres_.copyAll();
  } else {
    for (const Index i : changed) spheres_.copy(i);
  }
  forEachInChunks(changed.size(), [&](std::size_t k) { markAround(changed[k], slack[k]); });
}

void ForceCache::refreshAll() {
  neighbours_.update(agents_, range_);
  spheres_.copyAll();
  precisionHolds_ = spheres_.precisionHolds({});
  residual_.assign(agents_.size(), 0);
  stale_.resize(agents_.size());
  stale_.markAll();
}

void ForceCache::store(const ActiveSet& active, std::size_t place) {
  const Index i = active.agents()[place];
  const ActiveChunk& chunk = active.chunkOf(place);
  const std::size_t k = ActiveSet::inChunk(place);
  agents_.setPosition(i, chunk.position(k));
  agents_.stress[i] = chunk.stress[k];
  residual_[i] = chunk.residual[k];
}

void ForceCache::updateNeighbours(ActiveSet& active, std::span<const Index> moved) {
  std::vector<Index> agents;
  for (const Index place : moved) {
    const Index i = active.agents()[place];
    agents.push_back(i);
    store(active, place);
    // By the former list, as in refresh()
    markAround(i, active.chunkOf(place).path[ActiveSet::inChunk(place)]);
  }
  std::ranges::sort(agents);
  if (neighbours_.isBuiltFor(agents.size()))
    forEachInChunks(active.size(), [&](std::size_t place) { store(active, place); });
  const NeighbourList::Change change = neighbours_.update(agents_, agents);
  if (change.all) {
    stale_.markAll();
    for (ActiveChunk& chunk : active.chunks()) chunk.pairsCurrent = false;
  }
  const PairSource pairs = field_.pairs(agents_, neighbours_, bonds_);
  for (const Index i : change.agents) {
    if (!active.contains(i)) continue;
    const std::size_t place = active.placeOf(i);
    ActiveChunk& chunk = active.chunkOf(place);
    if (chunk.pairsCurrent) chunk.pairsCurrent = chunk.pairs.replace(pairs, ActiveSet::inChunk(place), i);
  }
}

void ForceCache::setForces(ActiveChunk& chunk, std::span<const AgentLoad> loads) const {
  for (std::size_t k = 0; k < loads.size(); ++k) {
    Vec3 force = loads[k].force();
    if (!(chunk.constraintMargin[k] > 0))
      constraints_.release(chunk.kind[k], chunk.radius[k], chunk.position(k), force);
    chunk.fx[k] = static_cast<float>(force.x());
    chunk.fy[k] = static_cast<float>(force.y());
    chunk.fz[k] = static_cast<float>(force.z());
    chunk.stiffness[k] = static_cast<float>(std::max(settings_.leastStiffness, loads[k].stiffness));
    chunk.stress[k] = static_cast<float>(loads[k].stress);
  }
  for (std::size_t k = 0; k < loads.size(); ++k) {
    const float squared = chunk.fx[k] * chunk.fx[k] + chunk.fy[k] * chunk.fy[k] + chunk.fz[k] * chunk.fz[k];
    chunk.residual[k] = std::sqrt(squared) / (chunk.stiffness[k] * chunk.radius[k]);
  }
}

template <class ChunkOf, class Done>
void ForceCache::evaluateChunks(std::span<const Index> agents, const ChunkOf& chunkOf, const Done& done) {
  First bad;
  spheres_.visit([&](const auto& spheres) {
    bad = reduceChunks<First>(agents.size(), [&](std::size_t begin, std::size_t end, First& part) {
      const auto ofChunk = agents.subspan(begin, end - begin);
      ActiveChunk& chunk = chunkOf(begin, ofChunk);
      if (!chunk.pairsCurrent)
        chunk.pairs.build(field_.pairs(agents_, neighbours_, bonds_), ofChunk, spheres_.none());
      chunk.pairsCurrent = true;
      std::array<AgentLoad, chunkSize> loads;
      field_.evaluate(spheres, chunk.pairs, ofChunk, loads);
      setForces(chunk, std::span(loads).first(ofChunk.size()));
      for (std::size_t k = 0; k < ofChunk.size(); ++k)
        if (!part.found && !std::isfinite(chunk.residual[k])) part = {true, ofChunk[k], chunk.force(k)};
      done(begin, chunk, ofChunk);
    });
  });
  evaluations_ += agents.size();
  if (!bad.found) return;
  throw std::runtime_error(
      fmt::format("the force on agent {} near ({}, {}, {}) m is not finite: ({}, {}, {}) N",
                  agents_.id[bad.agent], agents_.x[bad.agent], agents_.y[bad.agent], agents_.z[bad.agent],
                  bad.force.fx, bad.force.fy, bad.force.fz));
}

void ForceCache::evaluate(ActiveSet& active) {
  evaluateChunks(
      active.agents(),
      [&](std::size_t begin, std::span<const Index>) -> ActiveChunk& { return active.chunkOf(begin); },
      [](std::size_t, const ActiveChunk&, std::span<const Index>) {});
}

std::vector<AgentForce> ForceCache::evaluate(std::span<const Index> agents) {
  std::vector<AgentForce> forces(agents.size());
  const auto copyOf = [&](std::size_t, std::span<const Index> ofChunk) -> ActiveChunk& {
    thread_local ActiveChunk chunk;
    for (std::size_t k = 0; k < ofChunk.size(); ++k) {
      const Index i = ofChunk[k];
      chunk.set(k, agents_.kind[i], agents_.position(i), agents_.radius[i]);
    }
    chunk.pairsCurrent = false;
    return chunk;
  };
  const auto keep = [&](std::size_t begin, const ActiveChunk& chunk, std::span<const Index> ofChunk) {
    for (std::size_t k = 0; k < ofChunk.size(); ++k) {
      agents_.stress[ofChunk[k]] = chunk.stress[k];
      residual_[ofChunk[k]] = chunk.residual[k];
      forces[begin + k] = chunk.force(k);
    }
  };
  evaluateChunks(agents, copyOf, keep);
  return forces;
}

bool ForceCache::mayAct(Index i, Index j, double slack) const {
  const float squared = spheres_.squaredDistance(i, j);
  const float radii = beyondRounding * (spheres_.radius(i) + spheres_.radius(j));
  const auto isWithin = [&](double factor) {
    const float reach = static_cast<float>(factor) * radii + static_cast<float>(slack);
    return squared < reach * reach;
  };
  // The flags are read for few pairs: they are not where the spheres are.
  if (!isWithin(range_.largestFactor())) return false;
  const bool daughter = ((agents_.flags[i] | agents_.flags[j]) & AgentFlag::daughter) != 0;
  return isWithin(daughter ? range_.daughterFactor : range_.factor);
}

void ForceCache::markAround(Index i, double slack) {
  stale_.mark(i);
  for (const Index j : neighbours_.of(i))
    if (mayAct(i, j, slack)) stale_.mark(j);
  for (const Bond& bond : bonds_.of(i)) stale_.mark(bond.partner);
}

void ForceCache::checkPrecision(std::span<const Index> moved) {
  precisionHolds_ = precisionHolds_ && spheres_.precisionHolds(moved);
}

std::vector<Index> ForceCache::extractStale(const ActiveSet& active) {
  return stale_.extract([&](Index i) { return !active.contains(i) && agents_.kind[i] != AgentKind::strut; });
}

}  // namespace restenosis

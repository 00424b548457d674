#include "tissue/neighbours/NeighbourList.h"

#include <xxhash.h>

#include <algorithm>
#include <iterator>

#include "tissue/agents/Capacity.h"
#include "tissue/agents/Chunks.h"

namespace restenosis {
namespace {

// Speed only: results do not depend on when neighbours are found. Those of an agent are found with those that
// must be once it has less than this share of its allowance left, ...
constexpr double smallShare = 0.3;
// ... and those of all agents when it would be more than this share of them.
constexpr double mostRenewed = 0.1;

// A list that outgrew its capacity gets capacity for so many more entries.
constexpr std::uint32_t spareEntries = 8;
// Candidates for the neighbours of an agent in dense tissue, or some more.
constexpr std::size_t usualCandidates = 200;
// Searches of one thread at a time, and how many are worth waking other threads for.
constexpr std::ptrdiff_t searchesOfChunk = 16, parallelFromSearches = 64;

std::uint64_t hashOfIds(const AgentStore& agents, std::size_t count) {
  return XXH3_64bits(agents.id.data(), count * sizeof(AgentId));
}

}  // namespace

NeighbourList::Change NeighbourList::update(const AgentStore& agents, const NeighbourRange& range) {
  if (lists_.empty() || range != range_ || !sameAgents(agents)) {
    build(agents, range);
    return {.all = true, .agents = {}};
  }
  const std::vector<Index> stale = findStale(agents);
  return stale.empty() ? Change{} : renew(agents, stale);
}

NeighbourList::Change NeighbourList::update(const AgentStore& agents, std::span<const Index> moved) {
  const std::vector<Index> stale = agentsOf(moved, [&](Index i) { return hasSmallMargin(agents, i); });
  if (std::ranges::none_of(stale, [&](Index i) { return movedTooFar(agents, i); })) return {};
  return renew(agents, stale);
}

void NeighbourList::noteIds(const AgentStore& agents) { idHash_ = hashOfIds(agents, agents.size()); }

bool NeighbourList::sameAgents(const AgentStore& agents) const {
  return agents.size() >= size() && idHash_ == hashOfIds(agents, size());
}

double NeighbourList::smallMargin() const { return smallShare * range_.skin / 2; }

std::vector<Index> NeighbourList::findStale(const AgentStore& agents) {
  const auto changed = [&](Index i) { return listed_[i].daughter() != agents.has(i, AgentFlag::daughter); };
  const auto grown = [&](Index i) {
    return range_.largestFactor() * std::max(0.0, agents.radius[i] - listed_[i].radius());
  };
  std::vector<Index> stale = agentsThat(size(), [&](Index i) {
    listed_[i].setAllowance(range_.skin / 2 - grown(i));
    return changed(i) || hasSmallMargin(agents, i);
  });
  const bool necessary = agents.size() > size() || std::ranges::any_of(stale, [&](Index i) {
                           return changed(i) || movedTooFar(agents, i) || grown(i) > range_.skin / 2;
                         });
  if (!necessary) return {};
  for (Index i = size(); i < agents.size(); ++i) stale.push_back(i);
  return stale;
}

bool NeighbourList::isBuiltFor(std::size_t agents) const {
  return static_cast<double>(agents) > mostRenewed * size() || lists_.wasteful();
}

NeighbourList::Change NeighbourList::renew(const AgentStore& agents, std::span<const Index> stale) {
  if (isBuiltFor(stale.size())) {
    build(agents, range_);
    return {.all = true, .agents = {}};
  }
  for (const Index i : stale) finitePosition(agents, i);  // or throw, while the list is whole
  if (!grid_) {
    grid_.emplace(
        size(), [this](std::size_t i) -> const Vec3& { return listed_[i].position; },
        range_.widestReach(largestRadius_));
  }
  growCapacity(listed_, agents.size());
  lists_.resize(agents.size());
  isStale_.resize(agents.size(), 0);
  std::vector<Index> changed;
  for (const Index i : stale) {
    const bool isNew = i >= size();
    if (isNew) listed_.emplace_back();
    listed_[i] = ListedAgent(agents, i, range_);
    largestRadius_ = std::max(largestRadius_, listed_[i].radius());
    if (isNew) {
      grid_->add(listed_[i].position);
      changed.push_back(i);
    } else {
      grid_->move(i, listed_[i].position);
    }
    isStale_[i] = 1;
  }
  noteIds(agents);

  std::vector<std::vector<Index>> found(stale.size());
  const auto find = [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) found[k] = neighboursOf(stale[k]);
  };
  forEachChunk(stale.size(), find, parallelFromSearches, searchesOfChunk);
  for (std::size_t k = 0; k < stale.size(); ++k) replace(stale[k], found[k], changed);
  for (const Index i : stale) isStale_[i] = 0;
  std::ranges::sort(changed);
  const auto repeated = std::ranges::unique(changed);
  changed.erase(repeated.begin(), repeated.end());
  return {.all = false, .agents = std::move(changed)};
}

std::vector<Index> NeighbourList::neighboursOf(Index i) const {
  const ListedAgent& agent = listed_[i];
  std::vector<Index> found;
  found.reserve(usualCandidates);
  // Candidates are fetched together: they are far apart in memory
  grid_->forEachCandidate(agent.position, reachOf(range_, agent, largestRadius_), [&](Index j) {
    __builtin_prefetch(&listed_[j]);
    found.push_back(j);
  });
  std::erase_if(found, [&](Index j) { return j == i || !inRange(range_, agent, listed_[j]); });
  std::ranges::sort(found);
  return found;
}

void NeighbourList::replace(Index i, std::span<const Index> found, std::vector<Index>& changed) {
  const auto placeIn = [&](Index j) {
    return static_cast<std::size_t>(std::ranges::lower_bound(of(j), i) - of(j).begin());
  };
  std::vector<Index> lost, gained;
  std::ranges::set_difference(of(i), found, std::back_inserter(lost));
  std::ranges::set_difference(found, of(i), std::back_inserter(gained));
  for (const Index j : lost) {
    if (isStale_[j]) continue;
    lists_.erase(j, placeIn(j));
    changed.push_back(j);
  }
  for (const Index j : gained) {
    if (isStale_[j]) continue;
    lists_.insert(j, placeIn(j), i, spareEntries);
    changed.push_back(j);
  }
  if (lost.empty() && gained.empty()) return;
  changed.push_back(i);
  lists_.set(i, found, spareEntries);
}

}  // namespace restenosis

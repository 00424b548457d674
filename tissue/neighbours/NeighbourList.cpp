#include "NeighbourList.h"

#include <xxhash.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "CellGrid.h"
#include "Chunks.h"
#include "NeighbourQuery.h"
#include "Room.h"

namespace restenosis {
namespace {

// Speed only, as are all numbers here: results do not depend on when agents are looked up. An agent is looked
// up with those that must be once it has less than this share of its allowance left, ...
constexpr double leftBeforeLookUp = 0.3;
// ... and all are when more than this share would have to be.
constexpr double mostLookedUp = 0.1;

// A row that outgrew its room gets this much more than it needs.
constexpr std::uint32_t spareEntries = 8;
// Agents of a piece whose rows are found by one thread: when all are, and when some are looked up, and then
// how many are worth waking other threads for.
constexpr std::ptrdiff_t agentsOfPiece = 512, lookUpsOfPiece = 16, parallelFromLookUps = 256;

// No agent has this index.
constexpr Index none = std::numeric_limits<Index>::max();

double widestFactor(const NeighbourRange& range) { return std::max(range.factor, range.daughterFactor); }

/// Distance beyond which no two agents are in range [m].
double widestReach(const NeighbourRange& range, double largestRadius) {
  const double widest = 2 * widestFactor(range) * largestRadius + range.skin;
  return widest > 0 ? widest : 1.0;
}

/// Distance within which all agents in range of an agent with this anchor are [m].
double reachOf(const auto& anchor, const NeighbourRange& range, double largestRadius) {
  return widestFactor(range) * (anchor.radius() + largestRadius) + range.skin;
}

bool inRange(const NeighbourRange& range, const auto& a, const auto& b) {
  const Vec3 apart = a.position - b.position;
  const double factor = a.daughter() | b.daughter() ? range.daughterFactor : range.factor;
  const double reach = factor * (a.radius() + b.radius()) + range.skin;
  return apart.squaredNorm() <= reach * reach;
}

/// A number in single precision that is not below this one, or not above it.
float roundedUp(double value) {
  return std::nextafter(static_cast<float>(value), std::numeric_limits<float>::infinity());
}
float roundedDown(double value) {
  return std::nextafter(static_cast<float>(value), -std::numeric_limits<float>::infinity());
}

// Agents of a piece whose names are hashed together.
constexpr std::size_t namesOfPiece = 512;

/// Where the agents of a list were.
template <class Anchor>
auto placesOf(const std::vector<Anchor>& anchors) {
  return [&anchors](std::size_t i) -> const Vec3& { return anchors[i].position; };
}

/// Finds the agents in range of every agent, reading them in the order of the grid's cells.
template <class Anchor>
class SearchOfAll {
 public:
  SearchOfAll(const std::vector<Anchor>& anchors, const NeighbourRange& range, double largestRadius)
      : range_(range),
        largestRadius_(largestRadius),
        grid_(anchors.size(), placesOf(anchors), widestReach(range, largestRadius)) {
    candidates_.resize(anchors.size());
    forEachInChunks(anchors.size(), [&](std::size_t n) {
      const Index j = grid_.order()[n];
      candidates_[n] = {anchors[j], j};
    });
  }

  /// Appends the agents in range of agent i, in ascending order.
  void append(Index i, const Anchor& anchor, std::vector<Index>& row) const {
    const std::size_t first = row.size();
    std::size_t end = first;
    grid_.forEachCandidateRange(
        anchor.position, reachOf(anchor, range_, largestRadius_), [&](std::uint32_t from, std::uint32_t to) {
          // Each is written, and kept by counting it: no branch to be guessed wrong.
          row.resize(end + (to - from));
          Index* out = row.data() + end;
          for (std::uint32_t n = from; n < to; ++n) {
            *out = candidates_[n].agent;
            out += inRange(range_, anchor, candidates_[n].anchor) & (candidates_[n].agent != i);
          }
          end = static_cast<std::size_t>(out - row.data());
        });
    row.resize(end);
    std::sort(row.begin() + static_cast<std::ptrdiff_t>(first), row.end());
  }

 private:
  struct Candidate {
    Anchor anchor;
    Index agent;
  };

  NeighbourRange range_;
  double largestRadius_;
  CellGrid grid_;
  std::vector<Candidate> candidates_;
};

std::uint64_t hashOfNames(const AgentStore& agents, std::size_t piece, std::size_t count) {
  const std::size_t begin = piece * namesOfPiece, end = std::min(count, begin + namesOfPiece);
  return XXH3_64bits(agents.id.data() + begin, (end - begin) * sizeof(AgentId));
}

}  // namespace

NeighbourList::Anchor::Anchor(const Vec3& place, double agentRadius, bool isDaughter, double allowed)
    : position(place), radius_(isDaughter ? -roundedUp(agentRadius) : roundedUp(agentRadius)) {
  allow(allowed);
}

void NeighbourList::Anchor::allow(double distance) { allowance_ = std::max(0.0F, roundedDown(distance)); }

NeighbourList::Anchor NeighbourList::anchorOf(const AgentStore& agents, Index i,
                                              const NeighbourRange& range) {
  return {finitePosition(agents, i), agents.radius[i], agents.has(i, AgentFlag::daughter), range.skin / 2};
}

void NeighbourList::build(const AgentStore& agents, const NeighbourRange& range) {
  range_ = range;
  RowPool<Index> rows = std::exchange(rows_, {});  // should a position be found wrong below, there is no list
  grid_.reset();
  anchors_.resize(agents.size());
  for (Index i = 0; i < agents.size(); ++i) anchors_[i] = anchorOf(agents, i, range);
  largestRadius_ = 0;
  for (const Anchor& anchor : anchors_) largestRadius_ = std::max(largestRadius_, anchor.radius());
  noteNames(agents, 0);
  const SearchOfAll searchOfAll(anchors_, range, largestRadius_);

  const std::size_t count = anchors_.size();
  std::vector<std::vector<Index>> parts((count + agentsOfPiece - 1) / agentsOfPiece);
  std::vector<std::uint32_t> lengths(count);
  const auto search = [&](std::size_t begin, std::size_t end) {
    thread_local std::vector<Index> found;
    found.clear();
    for (std::size_t i = begin; i < end; ++i) {
      const std::size_t first = found.size();
      searchOfAll.append(static_cast<Index>(i), anchors_[i], found);
      lengths[i] = static_cast<std::uint32_t>(found.size() - first);
    }
    parts[begin / agentsOfPiece] = found;
  };
  forEachPiece(count, search, agentsOfPiece, agentsOfPiece);
  rows.layOut(count, [&](std::size_t i) { return lengths[i]; });
  forEachPiece(
      count,
      [&](std::size_t begin, std::size_t) {
        std::ranges::copy(parts[begin / agentsOfPiece], rows[begin].data());
      },
      agentsOfPiece, agentsOfPiece);
  rows_ = std::move(rows);
}

NeighbourList::Change NeighbourList::update(const AgentStore& agents, const NeighbourRange& range) {
  if (!rows_.empty() && range == range_ && sameAgents(agents)) {
    const std::vector<Index> names = findStale(agents);
    if (names.empty()) return {};
    if (worthLookingUp(names.size())) return {.all = false, .agents = lookUp(agents, names)};
  }
  build(agents, range);
  return {.all = true, .agents = {}};
}

NeighbourList::Change NeighbourList::update(const AgentStore& agents, std::span<const Index> moved) {
  const std::vector<Index> names = agentsOf(moved, [&](Index i) { return hasLittleRoom(agents, i); });
  if (std::ranges::none_of(names, [&](Index i) { return movedTooFar(agents, i); })) return {};
  if (worthLookingUp(names.size())) return {.all = false, .agents = lookUp(agents, names)};
  build(agents, range_);
  return {.all = true, .agents = {}};
}

bool NeighbourList::worthLookingUp(std::size_t agents) const {
  return static_cast<double>(agents) <= mostLookedUp * size() && !rows_.wasteful();
}

void NeighbourList::noteNames(const AgentStore& agents, Index first) {
  names_.resize((agents.size() + namesOfPiece - 1) / namesOfPiece);
  for (std::size_t piece = first / namesOfPiece; piece < names_.size(); ++piece)
    names_[piece] = hashOfNames(agents, piece, agents.size());
}

bool NeighbourList::sameAgents(const AgentStore& agents) const {
  if (agents.size() < size()) return false;
  for (std::size_t piece = 0; piece < names_.size(); ++piece)
    if (names_[piece] != hashOfNames(agents, piece, size())) return false;
  return true;
}

std::vector<Index> NeighbourList::findStale(const AgentStore& agents) {
  const auto changed = [&](Index i) { return anchors_[i].daughter() != agents.has(i, AgentFlag::daughter); };
  const auto growthOf = [&](Index i) { return std::max(0.0, agents.radius[i] - anchors_[i].radius()); };
  std::vector<Index> used = agentsThat(size(), [&](Index i) {
    anchors_[i].allow(range_.skin / 2 - widestFactor(range_) * growthOf(i));
    return changed(i) || hasLittleRoom(agents, i);
  });
  const bool necessary =
      agents.size() > size() || std::ranges::any_of(used, [&](Index i) {
        return changed(i) || movedTooFar(agents, i) || widestFactor(range_) * growthOf(i) > range_.skin / 2;
      });
  if (!necessary) return {};
  for (Index i = size(); i < agents.size(); ++i) used.push_back(i);
  return used;
}

double NeighbourList::comfortableRoom() const { return leftBeforeLookUp * range_.skin / 2; }

void NeighbourList::findInRange(std::span<const Index> agents, std::span<std::vector<Index>> found) const {
  // Agents looked up are far apart, and so is what each search reads: that of all is asked for step by step,
  // so that they wait for memory together.
  const auto reach = [this](Index i) { return reachOf(anchors_[i], range_, largestRadius_); };
  for (const Index i : agents) grid_->readRoomsAhead(anchors_[i].position, reach(i));
  for (const Index i : agents) grid_->readAhead(anchors_[i].position, reach(i));
  for (std::size_t k = 0; k < agents.size(); ++k) {
    found[k].clear();
    grid_->forEachCandidate(anchors_[agents[k]].position, reach(agents[k]), [&](Index j) {
      __builtin_prefetch(&anchors_[j]);
      found[k].push_back(j);
    });
  }
  for (std::size_t k = 0; k < agents.size(); ++k) {
    const Index i = agents[k];
    std::erase_if(found[k], [&](Index j) { return j == i || !inRange(range_, anchors_[i], anchors_[j]); });
    std::ranges::sort(found[k]);
  }
}

std::vector<Index> NeighbourList::lookUp(const AgentStore& agents, const std::vector<Index>& names) {
  for (const Index i : names) finitePosition(agents, i);  // or throw, while the list is whole
  if (!grid_) grid_.emplace(anchors_.size(), placesOf(anchors_), widestReach(range_, largestRadius_));
  const Index known = size();
  makeRoom(anchors_, agents.size());
  anchors_.resize(agents.size());
  rows_.resize(agents.size());
  stale_.resize(agents.size(), 0);
  for (const Index i : names) {
    anchors_[i] = anchorOf(agents, i, range_);
    largestRadius_ = std::max(largestRadius_, anchors_[i].radius());
    grid_->place(i, anchors_[i].position);
    stale_[i] = 1;
  }
  if (agents.size() > known) noteNames(agents, known);
  std::vector<std::vector<Index>> found(names.size());
  std::vector<std::vector<Edit>> editsOf(names.size());
  const auto isNew = [known](Index i) { return i >= known; };
  const auto lookAt = [&](std::size_t begin, std::size_t end) {
    thread_local std::array<std::vector<Index>, lookUpsOfPiece> rows;
    findInRange(std::span(names).subspan(begin, end - begin), rows);
    for (std::size_t k = begin; k < end; ++k) {
      const std::vector<Index>& row = rows[k - begin];
      editsOf[k] = difference(names[k], row);
      if (!editsOf[k].empty() || isNew(names[k])) found[k] = row;
    }
  };
  forEachPiece(names.size(), lookAt, parallelFromLookUps, lookUpsOfPiece);

  std::vector<Index> changed;
  std::vector<Edit> edits;  // of rows whose agents were not looked up themselves
  for (std::size_t k = 0; k < names.size(); ++k) {
    stale_[names[k]] = 0;
    if (editsOf[k].empty() && !isNew(names[k])) continue;
    changed.push_back(names[k]);
    rows_.set(names[k], found[k], spareEntries);
    std::ranges::copy_if(editsOf[k], std::back_inserter(edits),
                         [&](const Edit& edit) { return edit.row != none; });
  }
  std::ranges::sort(edits);
  std::vector<Index> edited, row;
  for (std::size_t first = 0; first < edits.size();) {
    std::size_t end = first;
    while (end < edits.size() && edits[end].row == edits[first].row) ++end;
    edited.push_back(edits[first].row);
    apply(std::span(edits).subspan(first, end - first), row);
    rows_.set(edits[first].row, row, spareEntries);
    first = end;
  }
  std::vector<Index> all;
  std::ranges::merge(edited, changed, std::back_inserter(all));
  return all;
}

std::vector<NeighbourList::Edit> NeighbourList::difference(Index i, const std::vector<Index>& row) const {
  std::vector<Edit> edits;
  const auto note = [&](Index j) { edits.push_back({.row = stale_[j] ? none : j, .neighbour = i}); };
  auto before = of(i).begin();
  const auto end = of(i).end();
  for (const Index j : row) {
    for (; before != end && *before < j; ++before) note(*before);
    if (before != end && *before == j)
      ++before;
    else
      note(j);
  }
  for (; before != end; ++before) note(*before);
  return edits;
}

void NeighbourList::apply(std::span<const Edit> edits, std::vector<Index>& row) const {
  row.clear();
  auto edit = edits.begin();
  for (const Index j : of(edits.front().row)) {
    for (; edit != edits.end() && edit->neighbour < j; ++edit) row.push_back(edit->neighbour);
    if (edit != edits.end() && edit->neighbour == j)
      ++edit;  // lost
    else
      row.push_back(j);
  }
  for (; edit != edits.end(); ++edit) row.push_back(edit->neighbour);
}

}  // namespace restenosis

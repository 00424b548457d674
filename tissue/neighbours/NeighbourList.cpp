#include "tissue/neighbours/NeighbourList.h"

#include <xxhash.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "tissue/agents/Chunks.h"
#include "tissue/agents/Capacity.h"
#include "tissue/neighbours/CellGrid.h"
#include "tissue/neighbours/NeighbourQuery.h"

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
constexpr std::ptrdiff_t agentsOfPiece = 512, lookUpsOfPiece = 16, parallelFromLookUps = 64;
// Room for the rows of a new list, over what those found first let expect: they grow by half or more before
// the list is built anew. What is not used takes no memory, and an array that must grow leaves the large
// pages it was on.
constexpr double roomForRows = 2;
// Pieces of which all rows are found before any of them is laid beside the others.
constexpr std::size_t piecesAtOnce = 128;
// Rows of a piece that are edited by one thread.
constexpr std::ptrdiff_t editsOfPiece = 64;

struct Largest {
  double value = 0;
  void join(const Largest& other) { value = std::max(value, other.value); }
};

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
  rows_ = {};  // should a position be found wrong below, there is no list
  grid_.reset();
  anchors_.resize(agents.size());
  for (Index i = 0; i < agents.size(); ++i) anchors_[i] = anchorOf(agents, i, range);
  largestRadius_ = 0;
  for (const Anchor& anchor : anchors_) largestRadius_ = std::max(largestRadius_, anchor.radius());
  noteNames(agents, 0);

  const SearchOfAll searchOfAll(anchors_, range, largestRadius_);
  struct Piece {
    std::vector<Index> found;
    std::vector<std::uint32_t> lengths;
  };
  std::vector<Piece> pieces(piecesAtOnce);
  RowPool<Index> rows;
  for (std::size_t first = 0; first < anchors_.size(); first += piecesAtOnce * agentsOfPiece) {
    const std::size_t count = std::min(anchors_.size() - first, piecesAtOnce * agentsOfPiece);
    const auto search = [&](std::size_t begin, std::size_t end) {
      Piece& piece = pieces[begin / agentsOfPiece];
      piece.found.clear(), piece.lengths.clear();
      for (std::size_t i = first + begin; i < first + end; ++i) {
        const std::size_t before = piece.found.size();
        searchOfAll.append(static_cast<Index>(i), anchors_[i], piece.found);
        piece.lengths.push_back(static_cast<std::uint32_t>(piece.found.size() - before));
      }
    };
    forEachPiece(count, search, agentsOfPiece, agentsOfPiece);
    if (first == 0) {
      std::size_t found = 0;
      for (const Piece& piece : pieces) found += piece.found.size();
      const double ofAll = static_cast<double>(found) / static_cast<double>(count) * size();
      rows.reserve(size(), static_cast<std::size_t>(roomForRows * ofAll));
    }
    for (std::size_t begin = 0; begin < count; begin += agentsOfPiece) {
      std::span<const Index> found(pieces[begin / agentsOfPiece].found);
      for (const std::uint32_t length : pieces[begin / agentsOfPiece].lengths) {
        rows.addRow(found.first(length));
        found = found.subspan(length);
      }
    }
  }
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
  const std::vector<Index> names = agentsOf(moved, [&](Index i) { return hasSmallMargin(agents, i); });
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
    return changed(i) || hasSmallMargin(agents, i);
  });
  const bool necessary =
      agents.size() > size() || std::ranges::any_of(used, [&](Index i) {
        return changed(i) || movedTooFar(agents, i) || widestFactor(range_) * growthOf(i) > range_.skin / 2;
      });
  if (!necessary) return {};
  for (Index i = size(); i < agents.size(); ++i) used.push_back(i);
  return used;
}

double NeighbourList::smallMargin() const { return leftBeforeLookUp * range_.skin / 2; }

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

std::vector<Index> NeighbourList::lookUp(const AgentStore& agents, std::span<const Index> names) {
  for (const Index i : names) finitePosition(agents, i);  // or throw, while the list is whole
  if (!grid_) grid_.emplace(anchors_.size(), placesOf(anchors_), widestReach(range_, largestRadius_));
  const Index known = size();
  growCapacity(anchors_, agents.size());
  anchors_.resize(agents.size());
  rows_.resize(agents.size());
  stale_.resize(agents.size(), 0);
  const auto setAnchor = [&](std::size_t k, Largest& radius) {
    const Index i = names[k];
    anchors_[i] = anchorOf(agents, i, range_);
    radius.join({anchors_[i].radius()});
    stale_[i] = 1;
  };
  largestRadius_ = std::max(largestRadius_, reduceInChunks<Largest>(names.size(), setAnchor).value);
  grid_->place(names, placesOf(anchors_));
  if (agents.size() > known) noteNames(agents, known);

  const Rows lookedUp = setRowsOf(names, known);
  const Rows edited = setRowsBy(lookedUp.edits);
  for (const Rows* rows : {&lookedUp, &edited})
    for (const auto& [i, row] : rows->grown) rows_.set(i, row, spareEntries);
  for (const Index i : names) stale_[i] = 0;
  std::vector<Index> changed;
  std::ranges::merge(lookedUp.changed, edited.changed, std::back_inserter(changed));
  return changed;
}

NeighbourList::Rows NeighbourList::setRowsOf(std::span<const Index> names, Index known) {
  Rows rows = inPieces(names.size(), lookUpsOfPiece, [&](std::size_t begin, std::size_t end, Rows& part) {
    const auto piece = names.subspan(begin, end - begin);
    thread_local std::array<std::vector<Index>, lookUpsOfPiece> found;
    findInRange(piece, found);
    rows_.readAhead(piece);
    for (std::size_t k = 0; k < piece.size(); ++k)
      if (noteDifference(piece[k], found[k], part.edits) || piece[k] >= known)
        setRow(piece[k], found[k], part);
  });
  std::ranges::sort(rows.edits);
  return rows;
}

NeighbourList::Rows NeighbourList::setRowsBy(std::span<const Edit> edits) {
  std::vector<std::span<const Edit>> ofRows;
  while (!edits.empty()) {
    const auto isOther = [&](const Edit& edit) { return edit.row != edits.front().row; };
    const auto end = std::ranges::find_if(edits, isOther);
    ofRows.emplace_back(edits.begin(), end);
    edits = {end, edits.end()};
  }
  return inPieces(ofRows.size(), editsOfPiece, [&](std::size_t begin, std::size_t end, Rows& part) {
    thread_local std::vector<Index> row;
    const auto piece = std::span(ofRows).subspan(begin, end - begin);
    for (const auto& ofRow : piece) rows_.readRoomAhead(ofRow.front().row);
    for (const auto& ofRow : piece) rows_.readAhead(ofRow.front().row);
    for (const auto& ofRow : piece) {
      apply(ofRow, row);
      setRow(ofRow.front().row, row, part);
    }
  });
}

template <class F>
NeighbourList::Rows NeighbourList::inPieces(std::size_t count, std::ptrdiff_t size, const F& f) {
  std::vector<Rows> parts((count + static_cast<std::size_t>(size) - 1) / static_cast<std::size_t>(size));
  forEachPiece(
      count,
      [&](std::size_t begin, std::size_t end) {
        Rows part;
        f(begin, end, part);
        parts[begin / static_cast<std::size_t>(size)] = std::move(part);
      },
      parallelFromLookUps, size);
  Rows all;
  const auto append = [](auto& to, auto& from) { std::ranges::move(from, std::back_inserter(to)); };
  for (Rows& part : parts)
    append(all.changed, part.changed), append(all.edits, part.edits), append(all.grown, part.grown);
  return all;
}

void NeighbourList::setRow(Index i, const std::vector<Index>& row, Rows& rows) {
  rows.changed.push_back(i);
  if (!rows_.setInPlace(i, row)) rows.grown.emplace_back(i, row);
}

bool NeighbourList::noteDifference(Index i, const std::vector<Index>& row, std::vector<Edit>& edits) const {
  bool any = false;
  const auto note = [&](Index j) {
    any = true;
    if (!stale_[j]) edits.push_back({.row = j, .neighbour = i});
  };
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
  return any;
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

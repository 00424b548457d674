#include "NeighbourList.h"

#include <algorithm>

#include "CellGrid.h"
#include "NeighbourQuery.h"

namespace restenosis {
namespace {

// Speed only, as are all numbers here: results do not depend on when agents are looked up. An agent is looked
// up with those that must be once it has used up this share of its allowance, ...
constexpr double usedBeforeLookUp = 0.6;
// ... and all are when more than this share would have to be.
constexpr double mostLookedUp = 0.25;

double widestFactor(const NeighbourRange& range) { return std::max(range.factor, range.daughterFactor); }

/// Finds the agents in range of a place, reading them in the order of the grid's cells.
class Search {
 public:
  /// `anchors`: the agents' positions, radii and whether they are daughters, of which no position differs by
  /// more than `drift` [m] from that in `agents`.
  template <class Anchors>
  Search(const AgentStore& agents, const Anchors& anchors, const NeighbourRange& range, double drift)
      : range_(range),
        drift_(drift),
        largestRadius_(largest(anchors)),
        grid_(agents, cellSize(2 * widestFactor(range) * largestRadius_ + range.skin)) {
    candidates_.reserve(anchors.size());
    for (const Index j : grid_.order()) {
      const auto& a = anchors[j];
      candidates_.push_back({a.position.x(), a.position.y(), a.position.z(), a.radius, j, a.daughter});
    }
  }

  /// Appends the agents in range of agent i, which stands exactly at its anchor, in ascending order.
  template <class Anchor>
  void append(Index i, const Anchor& anchor, std::vector<Index>& row) const {
    const Vec3& centre = anchor.position;
    const double radius = anchor.radius;
    const bool daughter = anchor.daughter;
    const std::size_t first = row.size();
    std::size_t end = first;
    const double reachOfAll = widestFactor(range_) * (radius + largestRadius_) + range_.skin + drift_;
    grid_.forEachCandidateRange(centre, reachOfAll, [&](std::uint32_t from, std::uint32_t to) {
      // Each is written, and kept by counting it: no branch to be guessed wrong.
      row.resize(end + (to - from));
      Index* out = row.data() + end;
      for (std::uint32_t n = from; n < to; ++n) {
        const Candidate& other = candidates_[n];
        const double dx = other.x - centre.x(), dy = other.y - centre.y(), dz = other.z - centre.z();
        const double factor = daughter | other.daughter ? range_.daughterFactor : range_.factor;
        const double reach = factor * (radius + other.radius) + range_.skin;
        *out = other.agent;
        out += (dx * dx + dy * dy + dz * dz <= reach * reach) & (other.agent != i);
      }
      end = static_cast<std::size_t>(out - row.data());
    });
    row.resize(end);
    std::sort(row.begin() + static_cast<std::ptrdiff_t>(first), row.end());
  }

 private:
  struct Candidate {
    double x, y, z, radius;
    Index agent;
    bool daughter;
  };
  template <class Anchors>
  static double largest(const Anchors& anchors) {
    double radius = 0;
    for (const auto& anchor : anchors) radius = std::max(radius, anchor.radius);
    return radius;
  }
  static double cellSize(double widest) { return widest > 0 ? widest : 1.0; }

  NeighbourRange range_;
  double drift_;
  double largestRadius_;
  CellGrid grid_;
  std::vector<Candidate> candidates_;
};

}  // namespace

NeighbourList::Anchor NeighbourList::anchorOf(const AgentStore& agents, Index i,
                                              const NeighbourRange& range) {
  return {.position = agents.position(i),
          .allowance = range.skin / 2,
          .radius = agents.radius[i],
          .id = agents.id[i],
          .daughter = agents.has(i, AgentFlag::daughter)};
}

/// Makes the rows of all agents: appendRow(i, row) appends those of agent i.
template <class F>
void NeighbourList::assemble(F&& appendRow) {
  constexpr Index chunk = 512;
  const Index count = size();
  const auto chunks = static_cast<std::ptrdiff_t>((count + chunk - 1) / chunk);
  std::vector<std::vector<Index>> parts(chunks);
  std::vector<std::size_t> start(count + std::size_t{1}, 0);
#pragma omp parallel for schedule(dynamic) if (chunks > 1)
  for (std::ptrdiff_t c = 0; c < chunks; ++c) {
    const auto begin = static_cast<Index>(c) * chunk;
    for (Index i = begin; i < std::min(count, begin + chunk); ++i) {
      const std::size_t first = parts[c].size();
      appendRow(i, parts[c]);
      start[i + 1] = parts[c].size() - first;
    }
  }
  for (Index i = 0; i < count; ++i) start[i + 1] += start[i];
  start_ = std::move(start);
  neighbours_.resize(start_[count]);
#pragma omp parallel for schedule(static) if (chunks > 1)
  for (std::ptrdiff_t c = 0; c < chunks; ++c) {
    std::copy(parts[c].begin(), parts[c].end(),
              neighbours_.begin() + static_cast<std::ptrdiff_t>(start_[static_cast<Index>(c) * chunk]));
  }
}

void NeighbourList::build(const AgentStore& agents, const NeighbourRange& range) {
  range_ = range;
  start_.clear();  // should a position be found wrong below, there is no list
  anchors_.resize(agents.size());
  for (Index i = 0; i < agents.size(); ++i) anchors_[i] = anchorOf(agents, i, range);
  const Search search(agents, anchors_, range, 0);
  assemble([&](Index i, std::vector<Index>& row) { search.append(i, anchors_[i], row); });
}

void NeighbourList::update(const AgentStore& agents, const NeighbourRange& range) {
  if (start_.empty() || !(range == range_) || !sameAgents(agents)) return build(agents, range);
  std::vector<std::uint8_t> stale(agents.size(), 0);
  const std::vector<Index> names = findStale(agents, stale);
  if (names.empty()) return;
  if (static_cast<double>(names.size()) > mostLookedUp * agents.size()) return build(agents, range);
  lookUp(agents, names, stale);
}

bool NeighbourList::sameAgents(const AgentStore& agents) const {
  if (agents.size() < size()) return false;
  for (Index i = 0; i < size(); ++i) {
    if (agents.id[i] != anchors_[i].id) return false;
  }
  return true;
}

std::vector<Index> NeighbourList::findStale(const AgentStore& agents, std::vector<std::uint8_t>& stale) {
  std::vector<Index> used;
  bool necessary = agents.size() > size();
  for (Index i = 0; i < size(); ++i) {
    Anchor& anchor = anchors_[i];
    const double growth = std::max(0.0, agents.radius[i] - anchor.radius);
    anchor.allowance = std::max(0.0, range_.skin / 2 - widestFactor(range_) * growth);
    const double room = anchor.allowance - usedBeforeLookUp * range_.skin / 2;
    const double moved2 = (agents.position(i) - anchor.position).squaredNorm();
    const bool changed = anchor.daughter != agents.has(i, AgentFlag::daughter);
    if (!changed && room >= 0 && moved2 <= room * room) continue;
    used.push_back(i);
    necessary |=
        changed || movedTooFar(i, agents.position(i)) || widestFactor(range_) * growth > range_.skin / 2;
  }
  if (!necessary) return {};
  for (Index i = size(); i < agents.size(); ++i) used.push_back(i);
  for (const Index i : used) stale[i] = 1;
  return used;
}

void NeighbourList::lookUp(const AgentStore& agents, const std::vector<Index>& names,
                           const std::vector<std::uint8_t>& stale) {
  const std::vector<std::size_t> startBefore = std::move(start_);
  start_.clear();  // as in `build`
  anchors_.resize(agents.size());
  for (const Index i : names) anchors_[i] = anchorOf(agents, i, range_);
  const Search search(agents, anchors_, range_, range_.skin / 2);

  std::vector<std::vector<Index>> rows(names.size());
  const auto count = static_cast<std::ptrdiff_t>(names.size());
#pragma omp parallel for schedule(dynamic, 16) if (count > 256)
  for (std::ptrdiff_t k = 0; k < count; ++k) search.append(names[k], anchors_[names[k]], rows[k]);

  // The same pairs seen from the agents that were not looked up.
  std::vector<std::uint32_t> start(agents.size() + std::size_t{1}, 0), place(agents.size(), 0);
  for (const auto& row : rows) {
    for (const Index j : row) start[j + 1] += !stale[j];
  }
  for (Index i = 0; i < agents.size(); ++i) start[i + 1] += start[i];
  std::vector<Index> found(start.back());
  std::vector<std::uint32_t> next(start.begin(), start.end() - 1);
  for (std::size_t k = 0; k < names.size(); ++k) {
    place[names[k]] = static_cast<std::uint32_t>(k);
    for (const Index j : rows[k]) {
      if (!stale[j]) found[next[j]++] = names[k];
    }
  }

  assemble([&](Index i, std::vector<Index>& row) {
    if (stale[i]) {
      const auto& own = rows[place[i]];
      row.insert(row.end(), own.begin(), own.end());
      return;
    }
    auto f = found.begin() + start[i];
    const auto end = found.begin() + start[i + 1];
    for (std::size_t n = startBefore[i]; n < startBefore[i + 1]; ++n) {
      const Index j = neighbours_[n];
      if (stale[j]) continue;
      for (; f != end && *f < j; ++f) row.push_back(*f);
      row.push_back(j);
    }
    row.insert(row.end(), f, end);
  });
}

bool NeighbourList::needsRebuild(const AgentStore& agents) const {
  if (agents.size() != size()) return true;
  for (Index i = 0; i < agents.size(); ++i) {
    if (movedTooFar(i, agents.position(i))) return true;
  }
  return false;
}

}  // namespace restenosis

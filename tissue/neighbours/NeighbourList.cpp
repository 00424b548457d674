#include "NeighbourList.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "CellGrid.h"
#include "NeighbourQuery.h"
#include "Room.h"

namespace restenosis {
namespace {

// Speed only, as are all numbers here: results do not depend on when agents are looked up. An agent is looked
// up with those that must be once it has less than this share of its allowance left, ...
constexpr double leftBeforeLookUp = 0.6;
// ... and all are when more than this share would have to be.
constexpr double mostLookedUp = 0.1;

// A row that outgrew its room gets this much more than it needs.
constexpr std::uint32_t spareEntries = 8;
// When more than this share of the entries is abandoned, the list is built anew.
constexpr double mostAbandoned = 0.25;

double widestFactor(const NeighbourRange& range) { return std::max(range.factor, range.daughterFactor); }

/// Finds the agents in range of a place, reading them in the order of the grid's cells.
class Search {
 public:
  /// Among the agents `names` with these `anchors`: their positions, radii and whether they are daughters.
  /// `largestRadius` of all agents [m].
  template <class Anchors>
  Search(const Anchors& anchors, std::span<const Index> names, const NeighbourRange& range,
         double largestRadius)
      : range_(range),
        largestRadius_(largestRadius),
        grid_(positions(anchors, names), widestReach(range, largestRadius)) {
    candidates_.reserve(names.size());
    for (const Index k : grid_.order()) {
      const auto& a = anchors[names[k]];
      candidates_.push_back({a.position.x(), a.position.y(), a.position.z(), a.radius, names[k], a.daughter});
    }
  }

  /// Distance beyond which no two agents are in range [m].
  static double widestReach(const NeighbourRange& range, double largestRadius) {
    const double widest = 2 * widestFactor(range) * largestRadius + range.skin;
    return widest > 0 ? widest : 1.0;
  }

  /// Appends the agents in range of agent i, which stands exactly at its anchor, in ascending order.
  template <class Anchor>
  void append(Index i, const Anchor& anchor, std::vector<Index>& row) const {
    const Vec3& centre = anchor.position;
    const double radius = anchor.radius;
    const bool daughter = anchor.daughter;
    const std::size_t first = row.size();
    std::size_t end = first;
    const double reachOfAll = widestFactor(range_) * (radius + largestRadius_) + range_.skin;
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
  static std::vector<Vec3> positions(const Anchors& anchors, std::span<const Index> names) {
    std::vector<Vec3> points;
    points.reserve(names.size());
    for (const Index j : names) points.push_back(anchors[j].position);
    return points;
  }

  NeighbourRange range_;
  double largestRadius_;
  CellGrid grid_;
  std::vector<Candidate> candidates_;
};

/// Largest radius of some anchors [m].
template <class Anchors>
double largestRadius(const Anchors& anchors) {
  double radius = 0;
  for (const auto& anchor : anchors) radius = std::max(radius, anchor.radius);
  return radius;
}

/// Tells who may be near some places: never a wrong no, seldom a wrong yes.
class Vicinity {
 public:
  explicit Vicinity(double reach) : reach_(reach), marked_(std::size_t{1} << bits, 0) {}

  void add(const Vec3& place) {
    for (int x = -1; x <= 1; ++x)
      for (int y = -1; y <= 1; ++y)
        for (int z = -1; z <= 1; ++z) marked_[key(place, x, y, z)] = 1;
  }
  bool has(const Vec3& place) const { return marked_[key(place, 0, 0, 0)] != 0; }

 private:
  static constexpr int bits = 18;
  /// Cells share marks, which costs a wrong yes now and then (Teschner et al. 2003).
  std::size_t key(const Vec3& place, int dx, int dy, int dz) const {
    const std::uint64_t mixed =
        cell(place.x(), dx) * 73856093U ^ cell(place.y(), dy) * 19349663U ^ cell(place.z(), dz) * 83492791U;
    return mixed & ((std::size_t{1} << bits) - 1);
  }
  std::uint64_t cell(double coordinate, int offset) const {
    constexpr double farthest = 1e15;  // so that the number of the cell is exact
    return static_cast<std::uint64_t>(
        static_cast<std::int64_t>(std::clamp(std::floor(coordinate / reach_), -farthest, farthest)) + offset);
  }

  double reach_;
  std::vector<std::uint8_t> marked_;
};

}  // namespace

NeighbourList::Anchor NeighbourList::anchorOf(const AgentStore& agents, Index i,
                                              const NeighbourRange& range) {
  return {.position = finitePosition(agents, i),
          .allowance = range.skin / 2,
          .radius = agents.radius[i],
          .id = agents.id[i],
          .daughter = agents.has(i, AgentFlag::daughter)};
}

void NeighbourList::build(const AgentStore& agents, const NeighbourRange& range) {
  range_ = range;
  rows_.clear();  // should a position be found wrong below, there is no list
  std::vector<Index> everyone(agents.size());
  std::iota(everyone.begin(), everyone.end(), Index{0});
  anchors_.resize(agents.size());
  for (Index i = 0; i < agents.size(); ++i) anchors_[i] = anchorOf(agents, i, range);
  const Search search(anchors_, everyone, range, largestRadius(anchors_));

  constexpr Index chunk = 512;
  const Index count = size();
  const auto chunks = static_cast<std::ptrdiff_t>((count + chunk - 1) / chunk);
  std::vector<std::vector<Index>> parts(chunks);
  std::vector<Row> rows(count);
#pragma omp parallel for schedule(dynamic) if (chunks > 1)
  for (std::ptrdiff_t c = 0; c < chunks; ++c) {
    const auto begin = static_cast<Index>(c) * chunk;
    for (Index i = begin; i < std::min(count, begin + chunk); ++i) {
      const std::size_t first = parts[c].size();
      search.append(i, anchors_[i], parts[c]);
      rows[i].count = rows[i].room = static_cast<std::uint32_t>(parts[c].size() - first);
    }
  }
  std::size_t end = 0;
  for (Row& row : rows) {
    row.start = end;
    end += row.count;
  }
  neighbours_.resize(end);
#pragma omp parallel for schedule(static) if (chunks > 1)
  for (std::ptrdiff_t c = 0; c < chunks; ++c) {
    const Row& first = rows[static_cast<Index>(c) * chunk];
    std::ranges::copy(parts[c], neighbours_.begin() + static_cast<std::ptrdiff_t>(first.start));
  }
  rows_ = std::move(rows);
  abandoned_ = 0;
}

NeighbourList::Change NeighbourList::update(const AgentStore& agents, const NeighbourRange& range) {
  const bool known = !rows_.empty() && range == range_ && sameAgents(agents);
  if (known) {
    std::vector<std::uint8_t> stale(agents.size(), 0);
    const std::vector<Index> names = findStale(agents, stale);
    const bool few =
        static_cast<double>(names.size()) <= mostLookedUp * agents.size() &&
        static_cast<double>(abandoned_) <= mostAbandoned * static_cast<double>(neighbours_.size());
    if (names.empty()) return {};
    if (few) return {.all = false, .agents = lookUp(agents, names, stale)};
  }
  build(agents, range);
  return {.all = true, .agents = {}};
}

std::size_t NeighbourList::pairCount() const {
  std::size_t entries = 0;
  for (const Row& row : rows_) entries += row.count;
  return entries / 2;
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
    const double room = anchor.allowance - leftBeforeLookUp * range_.skin / 2;
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

std::vector<Index> NeighbourList::lookUp(const AgentStore& agents, const std::vector<Index>& names,
                                         const std::vector<std::uint8_t>& stale) {
  for (const Index i : names) finitePosition(agents, i);  // or throw, while the list is whole
  makeRoom(anchors_, agents.size());
  makeRoom(rows_, agents.size());
  anchors_.resize(agents.size());
  rows_.resize(agents.size());
  for (const Index i : names) anchors_[i] = anchorOf(agents, i, range_);

  const double largest = largestRadius(anchors_);
  Vicinity vicinity(Search::widestReach(range_, largest));
  for (const Index i : names) vicinity.add(anchors_[i].position);
  std::vector<Index> near;
  for (Index i = 0; i < size(); ++i) {
    if (vicinity.has(anchors_[i].position)) near.push_back(i);
  }
  const Search search(anchors_, near, range_, largest);
  std::vector<std::vector<Index>> found(names.size());
  const auto count = static_cast<std::ptrdiff_t>(names.size());
#pragma omp parallel for schedule(dynamic, 16) if (count > 256)
  for (std::ptrdiff_t k = 0; k < count; ++k) search.append(names[k], anchors_[names[k]], found[k]);

  // The same pairs seen from the agents that were not looked up: whom they lose, and whom they have now.
  std::vector<std::pair<Index, Index>> others;
  std::vector<Index> beside;
  for (std::size_t k = 0; k < names.size(); ++k) {
    for (const Index j : of(names[k])) {
      if (!stale[j]) beside.push_back(j);
    }
    for (const Index j : found[k]) {
      if (!stale[j]) others.emplace_back(j, names[k]);
    }
  }
  std::ranges::sort(others);
  for (const auto& pair : others) beside.push_back(pair.first);
  std::ranges::sort(beside);
  beside.erase(std::unique(beside.begin(), beside.end()), beside.end());

  std::vector<Index> row;
  auto other = others.begin();
  for (const Index i : beside) {
    row.clear();
    for (const Index j : of(i)) {
      if (stale[j]) continue;
      for (; other != others.end() && other->first == i && other->second < j; ++other)
        row.push_back(other->second);
      row.push_back(j);
    }
    for (; other != others.end() && other->first == i; ++other) row.push_back(other->second);
    setRow(i, row);
  }
  for (std::size_t k = 0; k < names.size(); ++k) setRow(names[k], found[k]);

  std::vector<Index> changed;
  std::ranges::merge(beside, names, std::back_inserter(changed));
  return changed;
}

void NeighbourList::setRow(Index i, const std::vector<Index>& row) {
  Row& place = rows_[i];
  place.count = static_cast<std::uint32_t>(row.size());
  if (place.count > place.room) {
    abandoned_ += place.room;
    place.start = neighbours_.size();
    place.room = place.count + spareEntries;
    makeRoom(neighbours_, neighbours_.size() + place.room);
    neighbours_.resize(neighbours_.size() + place.room);
  }
  std::ranges::copy(row, neighbours_.begin() + static_cast<std::ptrdiff_t>(place.start));
}

}  // namespace restenosis

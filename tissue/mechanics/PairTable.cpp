#include "PairTable.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "Chunks.h"
#include "Room.h"

namespace restenosis {
namespace {

/// Calls f(partner, rest length) for the neighbours and bond partners of agent i in ascending order.
template <class F>
void forEachPartner(const NeighbourList& neighbours, const BondTable& bonds, Index i, F&& f) {
  constexpr float none = std::numeric_limits<float>::infinity();
  const auto near = neighbours.of(i);
  auto bond = bonds.of(i).begin();
  const auto lastBond = bonds.of(i).end();
  for (const Index j : near) {
    for (; bond != lastBond && bond->partner < j; ++bond) f(bond->partner, bond->restLength);
    const bool bonded = bond != lastBond && bond->partner == j;
    f(j, bonded ? bond->restLength : none);
    bond += bonded;
  }
  for (; bond != lastBond; ++bond) f(bond->partner, bond->restLength);
}

std::uint32_t partnerCount(const NeighbourList& neighbours, const BondTable& bonds, Index i) {
  std::uint32_t count = 0;
  forEachPartner(neighbours, bonds, i, [&](Index, float) { ++count; });
  return count;
}

/// Pieces of `agents`, which are in ascending order, that are of one group each.
std::vector<std::span<const Index>> runsOfGroups(std::span<const Index> agents) {
  std::vector<std::span<const Index>> runs;
  for (std::size_t k = 0; k < agents.size();) {
    const std::size_t first = k;
    while (k < agents.size() && agents[k] / laneCount == agents[first] / laneCount) ++k;
    runs.push_back(agents.subspan(first, k - first));
  }
  return runs;
}

// A row that outgrew its room gets this much more than it needs.
constexpr std::uint32_t spareBlocks = 4;
// When more than this share of the blocks is abandoned, all are laid out anew.
constexpr double mostAbandoned = 0.25;

}  // namespace

void PairTable::build(const NeighbourList& neighbours, const BondTable& bonds,
                      std::span<const std::uint8_t> flags, bool daughters) {
  size_ = neighbours.size();
  nobody_ = size_ + size_ / 8;
  layOut(neighbours, bonds, flags, daughters);
}

void PairTable::layOut(const NeighbourList& neighbours, const BondTable& bonds,
                       std::span<const std::uint8_t> flags, bool daughters) {
  const std::size_t groups = groupCount();
  rows_.resize(groups);
  marked_.assign(groups, 0);
  abandoned_ = 0;
  forEachInChunks(groups, [&](std::size_t g) {
    rows_[g].count = 0;
    for (Index i = firstOf(g); i < endOf(g); ++i)
      rows_[g].count = std::max(rows_[g].count, partnerCount(neighbours, bonds, i));
  });
  std::uint32_t end = 0;
  for (Row& row : rows_) {
    row.start = end;
    row.room = row.count;
    end += row.count;
  }
  blocks_.resize(end);
  forEachInChunks(groups, [&](std::size_t g) { fill(g, neighbours, bonds, flags, daughters); });
}

void PairTable::update(const NeighbourList& neighbours, const BondTable& bonds,
                       std::span<const std::uint8_t> flags, bool daughters, std::span<const Index> changed) {
  size_ = neighbours.size();
  makeRoom(rows_, groupCount());
  rows_.resize(groupCount());
  marked_.resize(groupCount(), 0);
  const auto runs = runsOfGroups(changed);
  // A group's blocks never become fewer here: rows that got shorter are filled up with nobody.
  std::vector<std::uint32_t> needed(runs.size());
  forEachInChunks(runs.size(), [&](std::size_t k) {
    needed[k] = rows_[runs[k].front() / laneCount].count;
    for (const Index i : runs[k]) needed[k] = std::max(needed[k], partnerCount(neighbours, bonds, i));
  });
  std::vector<std::uint8_t> whole(runs.size(), 0);
  for (std::size_t k = 0; k < runs.size(); ++k) {
    Row& row = rows_[runs[k].front() / laneCount];
    if (needed[k] == row.count) continue;
    row.count = needed[k];
    whole[k] = 1;
    if (row.count <= row.room) continue;
    abandoned_ += row.room;
    row.start = static_cast<std::uint32_t>(blocks_.size());
    row.room = row.count + spareBlocks;
    makeRoom(blocks_, blocks_.size() + row.room);
    blocks_.resize(blocks_.size() + row.room);
  }
  if (static_cast<double>(abandoned_) > mostAbandoned * static_cast<double>(blocks_.size()))
    return layOut(neighbours, bonds, flags, daughters);
  forEachInChunks(runs.size(), [&](std::size_t k) {
    if (whole[k]) return fill(runs[k].front() / laneCount, neighbours, bonds, flags, daughters);
    for (const Index i : runs[k]) fillLane(i, neighbours, bonds, flags, daughters);
  });
}

void PairTable::fill(std::size_t g, const NeighbourList& neighbours, const BondTable& bonds,
                     std::span<const std::uint8_t> flags, bool daughters) {
  marked_[g] = 0;
  const Index first = firstOf(g);
  for (Index i = first; i < first + laneCount; ++i) fillLane(i, neighbours, bonds, flags, daughters);
}

void PairTable::fillLane(Index i, const NeighbourList& neighbours, const BondTable& bonds,
                         std::span<const std::uint8_t> flags, bool daughters) {
  const std::size_t g = i / laneCount, lane = i % laneCount;
  std::uint32_t k = rows_[g].start;
  const std::uint32_t end = k + rows_[g].count;
  if (i < size_) {
    const bool daughter = daughters && (flags[i] & AgentFlag::daughter);
    forEachPartner(neighbours, bonds, i, [&](Index j, float rest) {
      const bool mark = daughter || (daughters && (flags[j] & AgentFlag::daughter));
      blocks_[k].partner[lane] = j;
      blocks_[k].rest[lane] = mark ? -rest : rest;
      if (mark) marked_[g] = 1;
      ++k;
    });
  }
  for (; k < end; ++k) {
    blocks_[k].partner[lane] = nobody_;
    blocks_[k].rest[lane] = std::numeric_limits<float>::infinity();
  }
}

}  // namespace restenosis

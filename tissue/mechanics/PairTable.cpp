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

/// Blocks that group g needs.
std::uint32_t longestRow(const NeighbourList& neighbours, const BondTable& bonds, std::size_t g) {
  std::uint32_t longest = 0;
  const auto end = std::min<std::size_t>(neighbours.size(), (g + 1) * laneCount);
  for (std::size_t i = g * laneCount; i < end; ++i)
    longest = std::max(longest, partnerCount(neighbours, bonds, static_cast<Index>(i)));
  return longest;
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
  const std::size_t groups = groupCount();
  rows_.resize(groups);
  marked_.assign(groups, 0);
  abandoned_ = 0;
  forEachInChunks(groups, [&](std::size_t g) { rows_[g].count = longestRow(neighbours, bonds, g); });
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
  std::vector<std::size_t> groups;
  for (const Index i : changed) groups.push_back(i / laneCount);
  std::ranges::sort(groups);
  groups.erase(std::unique(groups.begin(), groups.end()), groups.end());
  forEachInChunks(groups.size(),
                  [&](std::size_t k) { rows_[groups[k]].count = longestRow(neighbours, bonds, groups[k]); });
  for (const std::size_t g : groups) {
    Row& row = rows_[g];
    if (row.count <= row.room) continue;
    abandoned_ += row.room;
    row.start = static_cast<std::uint32_t>(blocks_.size());
    row.room = row.count + spareBlocks;
    makeRoom(blocks_, blocks_.size() + row.room);
    blocks_.resize(blocks_.size() + row.room);
  }
  if (static_cast<double>(abandoned_) > mostAbandoned * static_cast<double>(blocks_.size()))
    return build(neighbours, bonds, flags, daughters);
  forEachInChunks(groups.size(),
                  [&](std::size_t k) { fill(groups[k], neighbours, bonds, flags, daughters); });
}

void PairTable::fill(std::size_t g, const NeighbourList& neighbours, const BondTable& bonds,
                     std::span<const std::uint8_t> flags, bool daughters) {
  const std::uint32_t start = rows_[g].start, end = start + rows_[g].count;
  bool marked = false;
  for (int lane = 0; lane < laneCount; ++lane) {
    const auto i = static_cast<Index>(g * laneCount + static_cast<std::size_t>(lane));
    std::uint32_t k = start;
    if (i < size_) {
      const bool daughter = daughters && (flags[i] & AgentFlag::daughter);
      forEachPartner(neighbours, bonds, i, [&](Index j, float rest) {
        const bool mark = daughter || (daughters && (flags[j] & AgentFlag::daughter));
        blocks_[k].partner[lane] = j;
        blocks_[k].rest[lane] = mark ? -rest : rest;
        marked |= mark;
        ++k;
      });
    }
    for (; k < end; ++k) {
      blocks_[k].partner[lane] = nobody_;
      blocks_[k].rest[lane] = std::numeric_limits<float>::infinity();
    }
  }
  marked_[g] = marked;
}

}  // namespace restenosis

#include "PairTable.h"

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

// A row that outgrew its room gets this much more than it needs.
constexpr std::uint32_t spareBlocks = 1;
// When more than this share of the blocks is abandoned, all are laid out anew.
constexpr double mostAbandoned = 0.25;

}  // namespace

void PairTable::build(const NeighbourList& neighbours, const BondTable& bonds,
                      std::span<const std::uint8_t> flags, bool daughters) {
  nobody_ = neighbours.size() + neighbours.size() / 8;
  layOut(neighbours, bonds, flags, daughters);
}

void PairTable::layOut(const NeighbourList& neighbours, const BondTable& bonds,
                       std::span<const std::uint8_t> flags, bool daughters) {
  rows_.assign(neighbours.size(), Row{});
  abandoned_ = 0;
  forEachInChunks(rows_.size(), [&](std::size_t i) {
    rows_[i].length = partnerCount(neighbours, bonds, static_cast<Index>(i));
  });
  std::uint32_t end = 0;
  for (Row& row : rows_) {
    row.start = end;
    end += row.blocks();
  }
  // Not by resize: old and new blocks together would be the peak of a run's memory
  if (end > blocks_.capacity()) {
    std::vector<Block>().swap(blocks_);
    makeRoom(blocks_, end);
  }
  blocks_.resize(end);
  forEachInChunks(rows_.size(),
                  [&](std::size_t i) { fill(static_cast<Index>(i), neighbours, bonds, flags, daughters); });
}

void PairTable::update(const NeighbourList& neighbours, const BondTable& bonds,
                       std::span<const std::uint8_t> flags, bool daughters, std::span<const Index> changed) {
  makeRoom(rows_, neighbours.size());
  rows_.resize(neighbours.size());
  std::vector<std::uint32_t> needed(changed.size());
  forEachInChunks(changed.size(),
                  [&](std::size_t k) { needed[k] = partnerCount(neighbours, bonds, changed[k]); });
  std::size_t end = blocks_.size();
  for (std::size_t k = 0; k < changed.size(); ++k) {
    Row& row = rows_[changed[k]];
    // Rows that get shorter are filled up with nobody
    if (needed[k] <= row.length) continue;
    const std::uint32_t room = row.blocks() + row.spare;
    row.length = needed[k];
    if (row.blocks() <= room) {
      row.spare = room - row.blocks();
      continue;
    }
    abandoned_ += room;
    row.start = static_cast<std::uint32_t>(end);
    row.spare = spareBlocks;
    end += row.blocks() + row.spare;
  }
  if (end > blocks_.capacity() || static_cast<double>(abandoned_) > mostAbandoned * static_cast<double>(end))
    return layOut(neighbours, bonds, flags, daughters);
  blocks_.resize(end);
  forEachInChunks(changed.size(),
                  [&](std::size_t k) { fill(changed[k], neighbours, bonds, flags, daughters); });
}

void PairTable::fill(Index i, const NeighbourList& neighbours, const BondTable& bonds,
                     std::span<const std::uint8_t> flags, bool daughters) {
  Row& row = rows_[i];
  Block* const blocks = blocks_.data() + row.start;
  const bool daughter = daughters && (flags[i] & AgentFlag::daughter);
  bool marked = false;
  std::size_t k = 0;
  const auto put = [&](Index j, float rest) {
    blocks[k / width].partner[k % width] = j;
    blocks[k / width].rest[k % width] = rest;
    ++k;
  };
  forEachPartner(neighbours, bonds, i, [&](Index j, float rest) {
    const bool mark = daughter || (daughters && (flags[j] & AgentFlag::daughter));
    marked |= mark;
    put(j, mark ? -rest : rest);
  });
  row.marked = marked;
  for (const std::size_t end = std::size_t{row.blocks()} * width; k < end;)
    put(nobody_, std::numeric_limits<float>::infinity());
}

}  // namespace restenosis

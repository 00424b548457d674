#include "PairTable.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "Chunks.h"

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

}  // namespace

void PairTable::build(const NeighbourList& neighbours, const BondTable& bonds,
                      std::span<const std::uint8_t> flags, bool daughters) {
  size_ = neighbours.size();
  const std::size_t groups = (size_ + std::size_t{laneCount} - 1) / laneCount;
  start_.assign(groups + 1, 0);
  marked_.assign(groups, 0);
  forEachInChunks(groups, [&](std::size_t g) {
    std::uint32_t longest = 0;
    for (std::size_t i = g * laneCount; i < std::min<std::size_t>(size_, (g + 1) * laneCount); ++i) {
      std::uint32_t count = 0;
      forEachPartner(neighbours, bonds, static_cast<Index>(i), [&](Index, float) { ++count; });
      longest = std::max(longest, count);
    }
    start_[g + 1] = longest;
  });
  for (std::size_t g = 0; g < groups; ++g) start_[g + 1] += start_[g];
  blocks_.resize(start_[groups]);

  forEachInChunks(groups, [&](std::size_t g) {
    bool marked = false;
    for (int lane = 0; lane < laneCount; ++lane) {
      const auto i = static_cast<Index>(g * laneCount + static_cast<std::size_t>(lane));
      std::uint32_t k = start_[g];
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
      for (; k < start_[g + 1]; ++k) {
        blocks_[k].partner[lane] = size_;
        blocks_[k].rest[lane] = std::numeric_limits<float>::infinity();
      }
    }
    marked_[g] = marked;
  });
}

}  // namespace restenosis

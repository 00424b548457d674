#include "tissue/agents/BondCandidates.h"

#include <algorithm>
#include <cstdint>
#include <tuple>

namespace restenosis {

std::size_t connectNearestFirst(const AgentStore& agents, BondTable& bonds,
                                std::vector<BondCandidate> candidates) {
  const auto key = [&](const BondCandidate& pair) {
    const auto [low, high] = std::minmax(agents.id[pair.a], agents.id[pair.b]);
    return std::tuple(pair.distance, low, high);
  };
  std::erase_if(candidates, [&](const BondCandidate& pair) {
    return pair.distance < nearestBonded * (agents.radius[pair.a] + agents.radius[pair.b]);
  });
  std::vector<std::uint32_t> wanted(agents.size());
  for (const BondCandidate& pair : candidates) ++wanted[pair.a], ++wanted[pair.b];
  const auto left = [&](Index i) { return BondTable::maxBonds - bonds.of(i).size(); };
  if (candidates.size() > agents.size()) {
    bonds.reserveMore(
        [&](Index i) { return static_cast<std::uint32_t>(std::min<std::size_t>(wanted[i], left(i))); });
  }
  // Agents that may have all their candidates get them in any order: that of memory is the quickest.
  const auto getsAll = [&](Index i) { return wanted[i] <= left(i); };
  std::size_t made = 0;
  std::erase_if(candidates, [&](const BondCandidate& pair) {
    if (!getsAll(pair.a) || !getsAll(pair.b)) return false;
    --wanted[pair.a], --wanted[pair.b];
    made += bonds.connect(pair.a, pair.b, pair.distance);
    return true;
  });
  std::ranges::sort(candidates, [&](const auto& p, const auto& q) { return key(p) < key(q); });
  for (const BondCandidate& pair : candidates) made += bonds.connect(pair.a, pair.b, pair.distance);
  return made;
}

}  // namespace restenosis

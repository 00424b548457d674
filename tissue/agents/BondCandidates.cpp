#include "BondCandidates.h"

#include <algorithm>
#include <tuple>

namespace restenosis {

std::size_t connectNearestFirst(const AgentStore& agents, BondTable& bonds,
                                std::vector<BondCandidate> candidates) {
  const auto key = [&](const BondCandidate& pair) {
    const auto [low, high] = std::minmax(agents.id[pair.a], agents.id[pair.b]);
    return std::tuple(pair.distance, low, high);
  };
  std::ranges::sort(candidates, [&](const auto& p, const auto& q) { return key(p) < key(q); });
  std::size_t made = 0;
  for (const BondCandidate& pair : candidates) made += bonds.connect(pair.a, pair.b, pair.distance);
  return made;
}

}  // namespace restenosis

#include "tissue/forces/PairSource.h"

#include <limits>

namespace restenosis {

void PairSource::append(Index i, std::vector<Pair>& pairs) const {
  constexpr float unbonded = std::numeric_limits<float>::infinity();
  const auto isDaughter = [this](Index j) { return cohesion && (flags[j] & AgentFlag::daughter); };
  const bool daughter = isDaughter(i);
  const auto put = [&](Index j, float restLength) {
    pairs.push_back({j, daughter || isDaughter(j) ? -restLength : restLength});
  };
  const auto bonded = bonds.of(i);
  auto bond = bonded.begin();
  for (const Index j : neighbours.of(i)) {
    for (; bond != bonded.end() && bond->partner < j; ++bond) put(bond->partner, bond->restLength);
    const bool isBonded = bond != bonded.end() && bond->partner == j;
    put(j, isBonded ? bond->restLength : unbonded);
    bond += isBonded;
  }
  for (; bond != bonded.end(); ++bond) put(bond->partner, bond->restLength);
}

}  // namespace restenosis

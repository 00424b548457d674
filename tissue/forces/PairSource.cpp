#include "tissue/forces/PairSource.h"

namespace restenosis {

void PairSource::append(Index i, std::vector<Pair>& pairs) const {
  const auto isDaughter = [this](Index j) { return cohesion && (flags[j] & AgentFlag::daughter); };
  const bool daughter = isDaughter(i);
  const auto listed = neighbours.of(i);
  const auto bonded = bonds.of(i);
  const std::size_t first = pairs.size();
  pairs.resize(first + listed.size() + bonded.size());
  Pair* next = pairs.data() + first;
  const auto put = [&](Index j, float restLength) {
    *next++ = {j, daughter || isDaughter(j) ? -restLength : restLength};
  };
  auto bond = bonded.begin();
  for (const Index j : listed) {
    for (; bond != bonded.end() && bond->partner < j; ++bond) put(bond->partner, bond->restLength);
    const bool isBonded = bond != bonded.end() && bond->partner == j;
    put(j, isBonded ? bond->restLength : Pair::unbonded);
    bond += isBonded;
  }
  for (; bond != bonded.end(); ++bond) put(bond->partner, bond->restLength);
  pairs.resize(static_cast<std::size_t>(next - pairs.data()));
}

}  // namespace restenosis

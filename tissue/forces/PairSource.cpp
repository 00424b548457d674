#include "tissue/forces/PairSource.h"

#include <limits>

namespace restenosis {

bool PairSource::append(Index i, std::vector<ActingPair>& pairs) const {
  constexpr float none = std::numeric_limits<float>::infinity();
  const bool daughter = marksDaughters && (flags[i] & AgentFlag::daughter);
  bool marked = false;
  const auto put = [&](Index j, float rest) {
    const bool mark = daughter || (marksDaughters && (flags[j] & AgentFlag::daughter));
    marked |= mark;
    pairs.push_back({j, mark ? -rest : rest});
  };
  const auto bonded = bonds.of(i);
  auto bond = bonded.begin();
  for (const Index j : neighbours.of(i)) {
    for (; bond != bonded.end() && bond->partner < j; ++bond) put(bond->partner, bond->restLength);
    const bool isBonded = bond != bonded.end() && bond->partner == j;
    put(j, isBonded ? bond->restLength : none);
    bond += isBonded;
  }
  for (; bond != bonded.end(); ++bond) put(bond->partner, bond->restLength);
  return marked;
}

}  // namespace restenosis

#include "tissue/biology/NeighbourCountLaw.h"

#include <array>

namespace restenosis {

bool NeighbourCountLaw::inhibits(const Surroundings& surroundings) const {
  // Whole numbers by kind, weighted at the end: a sum of weights would depend on the order of the neighbours.
  std::array<int, 4> count{};
  for (const ContactNeighbour& n : surroundings.neighbours) {
    if (n.distance <= p_.countRange * (surroundings.radius + n.radius))
      ++count[static_cast<std::size_t>(n.kind)];
  }
  const auto number = [&](AgentKind kind) {
    return static_cast<double>(count[static_cast<std::size_t>(kind)]);
  };
  const double sum = p_.smcWeight * number(AgentKind::smc) + p_.ielWeight * number(AgentKind::iel) +
                     p_.eelWeight * number(AgentKind::eel) + p_.strutWeight * number(AgentKind::strut);
  return sum > p_.countThreshold;
}

}  // namespace restenosis

#include "tissue/biology/ExtracellularMatrix.h"

#include <algorithm>

#include "tissue/agents/Chunks.h"
#include "tissue/biology/CellCycle.h"

namespace restenosis {

bool ExtracellularMatrix::deposit(AgentStore& agents, double duration) const {
  const double largestOverCell = p_.largestShare / (1 - p_.largestShare);
  struct Any {
    bool deposited = false;
    void join(const Any& other) { deposited |= other.deposited; }
  };
  const auto cube = [](double length) { return length * length * length; };
  return reduceInChunks<Any>(
             agents.size(),
             [&](std::size_t k, Any& any) {
               const auto i = static_cast<Index>(k);
               if (!CellCycle::cycles(agents, i) || !agents.has(i, synthetic) || agents.has(i, inhibited))
                 return;
               const double cell = agents.cellRadius(i);
               const float before = agents.matrix[i];
               const double activation = agents.activation.modelled() ? agents.activation[i] : 1.0F;
               const double added = p_.rate * duration * activation * cube(agents.birthRadius[i]);
               const auto after = std::max(
                   before, static_cast<float>(std::min(before + added, largestOverCell * cube(cell))));
               if (after == before) return;
               agents.setCell(i, cell, after);
               any.deposited = true;
             })
      .deposited;
}

}  // namespace restenosis

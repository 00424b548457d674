#include "tissue/neighbours/ListedAgent.h"

#include <algorithm>
#include <limits>

#include "tissue/neighbours/CellGrid.h"

namespace restenosis {
namespace {

/// A number in single precision that is not below this one, or not above it.
float roundedUp(double value) {
  return std::nextafter(static_cast<float>(value), std::numeric_limits<float>::infinity());
}
float roundedDown(double value) {
  return std::nextafter(static_cast<float>(value), -std::numeric_limits<float>::infinity());
}

}  // namespace

ListedAgent::ListedAgent(const AgentStore& agents, Index i, const NeighbourRange& range)
    : position(finitePosition(agents, i)), radius_(roundedUp(agents.radius[i])) {
  if (agents.has(i, AgentFlag::daughter)) radius_ = -radius_;
  setAllowance(range.skin / 2);
}

void ListedAgent::setAllowance(double distance) { allowance_ = std::max(0.0F, roundedDown(distance)); }

}  // namespace restenosis

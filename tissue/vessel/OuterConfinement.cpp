#include "OuterConfinement.h"

#include "Cylindrical.h"

namespace restenosis {

OuterConfinement::OuterConfinement(const AgentStore& agents, double cellRadius, double margin)
    : map_(agents, AgentKind::eel, 2 * cellRadius), margin_(margin) {}

void OuterConfinement::project(const AgentStore& agents, Index i, Vec3& position) const {
  if (agents.kind[i] != AgentKind::smc && agents.kind[i] != AgentKind::iel) return;
  const double limit = map_.at(position) - margin_ * agents.radius[i];
  if (radiusOf(position) > limit) position = atRadius(position, limit);
}

void OuterConfinement::release(const AgentStore& agents, Index i, Vec3& force) const {
  if (agents.kind[i] != AgentKind::smc && agents.kind[i] != AgentKind::iel) return;
  const Vec3 position = agents.position(i), out = radialAt(position);
  const double limit = map_.at(position) - margin_ * agents.radius[i];
  const double outward = force.dot(out);
  // Rounding of the projection is far below a billionth of the radius.
  if (outward > 0 && radiusOf(position) >= limit * (1 - 1e-9)) force -= outward * out;
}

}  // namespace restenosis

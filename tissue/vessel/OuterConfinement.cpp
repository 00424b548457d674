#include "OuterConfinement.h"

#include "Cylindrical.h"

namespace restenosis {

OuterConfinement::OuterConfinement(const AgentStore& agents, double cellRadius, double margin)
    : map_(agents, AgentKind::eel, 2 * cellRadius), nearest_(map_.lowest()), margin_(margin) {}

bool OuterConfinement::deepInside(double x, double y, double radius) const {
  // The share of a millionth is beyond the slack that `release` grants for rounding.
  const double within = (nearest_ - margin_ * radius) * (1 - 1e-6);
  return within > 0 && x * x + y * y < within * within;
}

void OuterConfinement::project(const AgentStore& agents, Index i, Vec3& position) const {
  if (agents.kind[i] != AgentKind::smc && agents.kind[i] != AgentKind::iel) return;
  if (deepInside(position.x(), position.y(), agents.radius[i])) return;
  const double limit = map_.at(position) - margin_ * agents.radius[i];
  if (radiusOf(position) > limit) position = atRadius(position, limit);
}

void OuterConfinement::release(const AgentStore& agents, Index i, Vec3& force) const {
  if (agents.kind[i] != AgentKind::smc && agents.kind[i] != AgentKind::iel) return;
  if (deepInside(agents.x[i], agents.y[i], agents.radius[i])) return;
  const Vec3 position = agents.position(i), out = radialAt(position);
  const double limit = map_.at(position) - margin_ * agents.radius[i];
  const double outward = force.dot(out);
  // Rounding of the projection is far below a billionth of the radius.
  if (outward > 0 && radiusOf(position) >= limit * (1 - 1e-9)) force -= outward * out;
}

}  // namespace restenosis

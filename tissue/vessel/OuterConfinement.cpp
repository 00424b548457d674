#include "OuterConfinement.h"

#include "Cylindrical.h"

namespace restenosis {

OuterConfinement::OuterConfinement(const AgentStore& agents, double cellRadius, double margin)
    : map_(agents, AgentKind::eel, 2 * cellRadius), margin_(margin) {}

bool OuterConfinement::deepInside(const Vec3& position, double radius) const {
  const double squared = position.head<2>().squaredNorm();
  const auto isWithin = [&](double surface) {
    // Clearly farther in than what `release` takes for on the surface.
    const double within = (surface - margin_ * radius) * (1 - 2 * onSurface);
    return within > 0 && squared < within * within;
  };
  return isWithin(map_.lowest()) || isWithin(map_.lowestNear(position.x(), position.y(), position.z()));
}

void OuterConfinement::project(const AgentStore& agents, Index i, Vec3& position) const {
  if (agents.kind[i] != AgentKind::smc && agents.kind[i] != AgentKind::iel) return;
  if (deepInside(position, agents.radius[i])) return;
  const double limit = map_.at(position) - margin_ * agents.radius[i];
  if (radiusOf(position) > limit) position = atRadius(position, limit);
}

void OuterConfinement::release(const AgentStore& agents, Index i, Vec3& force) const {
  if (agents.kind[i] != AgentKind::smc && agents.kind[i] != AgentKind::iel) return;
  const Vec3 position = agents.position(i);
  if (deepInside(position, agents.radius[i])) return;
  const Vec3 out = radialAt(position);
  const double limit = map_.at(position) - margin_ * agents.radius[i];
  const double outward = force.dot(out);
  if (outward > 0 && radiusOf(position) >= limit * (1 - onSurface)) force -= outward * out;
}

}  // namespace restenosis

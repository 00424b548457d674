#include "tissue/vessel/OuterConfinement.h"

#include <limits>

#include "tissue/vessel/Cylindrical.h"

namespace restenosis {

OuterConfinement::OuterConfinement(const AgentStore& agents, double cellRadius, double margin)
    : map_(agents, AgentKind::eel, 2 * cellRadius), margin_(margin) {}

double OuterConfinement::clearlyInside(double surface, double radius) const {
  return (surface - margin_ * radius) * (1 - 2 * onSurface);
}

bool OuterConfinement::deepInside(const Vec3& position, double radius) const {
  const double squared = position.head<2>().squaredNorm();
  const auto isWithin = [&](double surface) {
    const double within = clearlyInside(surface, radius);
    return within > 0 && squared < within * within;
  };
  return isWithin(map_.lowest()) || isWithin(map_.lowestNear(position.x(), position.y(), position.z()));
}

void OuterConfinement::project(AgentKind kind, double radius, Vec3& position) const {
  if (kind != AgentKind::smc && kind != AgentKind::iel) return;
  if (deepInside(position, radius)) return;
  const double limit = map_.at(position) - margin_ * radius;
  if (radiusOf(position) > limit) position = atRadius(position, limit);
}

double OuterConfinement::margin(AgentKind kind, double radius, const Vec3& position) const {
  if (kind != AgentKind::smc && kind != AgentKind::iel) return std::numeric_limits<double>::infinity();
  return clearlyInside(map_.lowest(), radius) - radiusOf(position);
}

void OuterConfinement::release(AgentKind kind, double radius, const Vec3& position, Vec3& force) const {
  if (kind != AgentKind::smc && kind != AgentKind::iel) return;
  if (deepInside(position, radius)) return;
  const Vec3 out = radialAt(position);
  const double limit = map_.at(position) - margin_ * radius;
  const double outward = force.dot(out);
  if (outward > 0 && radiusOf(position) >= limit * (1 - onSurface)) force -= outward * out;
}

}  // namespace restenosis

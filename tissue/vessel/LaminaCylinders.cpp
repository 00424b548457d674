#include "LaminaCylinders.h"

#include <algorithm>

#include "Cylindrical.h"

namespace restenosis {

void LaminaCylinders::project(AgentKind kind, double, Vec3& position) const {
  switch (kind) {
    case AgentKind::iel:
      position = atRadius(position, ielRadius_);
      break;
    case AgentKind::eel:
      position = atRadius(position, eelRadius_);
      break;
    case AgentKind::smc: {
      const double radius = radiusOf(position);
      const double allowed = std::clamp(radius, ielRadius_ + clearance_, eelRadius_ - clearance_);
      if (radius != allowed) position = atRadius(position, allowed);
      break;
    }
    case AgentKind::strut:
      break;
  }
}

void LaminaCylinders::release(AgentKind kind, double, const Vec3& position, Vec3& force) const {
  const Vec3 out = radialAt(position);
  const double outward = force.dot(out), radius = radiusOf(position);
  const bool onLamina = kind == AgentKind::iel || kind == AgentKind::eel;
  const bool atInner =
      kind == AgentKind::smc && outward < 0 && radius <= (ielRadius_ + clearance_) * (1 + onSurface);
  const bool atOuter =
      kind == AgentKind::smc && outward > 0 && radius >= (eelRadius_ - clearance_) * (1 - onSurface);
  if (onLamina || atInner || atOuter) force -= outward * out;
}

}  // namespace restenosis

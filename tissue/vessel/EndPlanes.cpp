#include "tissue/vessel/EndPlanes.h"

#include <algorithm>

namespace restenosis {

void EndPlanes::project(AgentKind, double, Vec3& position) const {
  position.z() = std::clamp(position.z(), 0.0, length_);
}

double EndPlanes::margin(AgentKind, double, const Vec3& position) const {
  return std::min(position.z(), length_ - position.z());
}

void EndPlanes::release(AgentKind, double, const Vec3& position, Vec3& force) const {
  if ((position.z() <= 0 && force.z() < 0) || (position.z() >= length_ && force.z() > 0)) force.z() = 0;
}

}  // namespace restenosis

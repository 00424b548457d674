#include "EndPlanes.h"

#include <algorithm>

namespace restenosis {

void EndPlanes::project(const AgentStore&, Index, Vec3& position) const {
  position.z() = std::clamp(position.z(), 0.0, length_);
}

void EndPlanes::release(const AgentStore& agents, Index i, Vec3& force) const {
  if ((agents.z[i] <= 0 && force.z() < 0) || (agents.z[i] >= length_ && force.z() > 0)) force.z() = 0;
}

}  // namespace restenosis

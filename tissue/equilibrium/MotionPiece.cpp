#include "tissue/equilibrium/MotionPiece.h"

namespace restenosis {

void MotionPiece::setNow(std::size_t k, const AgentForce& now) {
  setForce(k, now.force);
  stiffness[k] = static_cast<float>(now.stiffness), residual[k] = static_cast<float>(now.residual);
}

void MotionPiece::set(std::size_t k, const AgentMotion& agent) {
  x[k] = agent.position.x(), y[k] = agent.position.y(), z[k] = agent.position.z();
  vx[k] = vy[k] = vz[k] = 0;
  setNow(k, {.stiffness = 1});
  radius[k] = static_cast<float>(agent.radius), leash[k] = agent.leash, room[k] = agent.room, way[k] = 0;
  kind[k] = agent.kind, daughter[k] = agent.daughter;
}

void MotionPiece::copy(std::size_t k, const MotionPiece& from, std::size_t m) {
  x[k] = from.x[m], y[k] = from.y[m], z[k] = from.z[m];
  vx[k] = from.vx[m], vy[k] = from.vy[m], vz[k] = from.vz[m];
  fx[k] = from.fx[m], fy[k] = from.fy[m], fz[k] = from.fz[m];
  stiffness[k] = from.stiffness[m], residual[k] = from.residual[m];
  radius[k] = from.radius[m], leash[k] = from.leash[m], room[k] = from.room[m], way[k] = from.way[m];
  kind[k] = from.kind[m], daughter[k] = from.daughter[m];
}

void MotionPiece::fillLanes(std::size_t count) {
  for (std::size_t k = count; k % lanes != 0; ++k) set(k, {.radius = 1});
}

}  // namespace restenosis

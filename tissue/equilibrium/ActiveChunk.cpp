#include "tissue/equilibrium/ActiveChunk.h"

namespace restenosis {

void ActiveChunk::setForce(std::size_t k, const AgentForce& force) {
  fx[k] = force.fx, fy[k] = force.fy, fz[k] = force.fz;
  stiffness[k] = force.stiffness, residual[k] = force.residual, stress[k] = force.stress;
}

void ActiveChunk::set(std::size_t k, AgentKind ofKind, const Vec3& position, double ofRadius) {
  x[k] = position.x(), y[k] = position.y(), z[k] = position.z();
  vx[k] = vy[k] = vz[k] = 0;
  setForce(k, {});
  radius[k] = static_cast<float>(ofRadius);
  listMargin[k] = constraintMargin[k] = path[k] = unreviewed[k] = 0;
  kind[k] = ofKind;
}

void ActiveChunk::copy(std::size_t k, const ActiveChunk& from, std::size_t m) {
  x[k] = from.x[m], y[k] = from.y[m], z[k] = from.z[m];
  vx[k] = from.vx[m], vy[k] = from.vy[m], vz[k] = from.vz[m];
  setForce(k, from.force(m));
  radius[k] = from.radius[m];
  listMargin[k] = from.listMargin[m], constraintMargin[k] = from.constraintMargin[m];
  path[k] = from.path[m], unreviewed[k] = from.unreviewed[m];
  kind[k] = from.kind[m];
}

void ActiveChunk::fillLanes(std::size_t count) {
  for (std::size_t k = count; k % lanes != 0; ++k) set(k, AgentKind::smc, Vec3::Zero(), 1);
}

}  // namespace restenosis

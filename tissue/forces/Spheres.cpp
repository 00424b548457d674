#include "tissue/forces/Spheres.h"

#include <cmath>

namespace restenosis {

std::vector<Sphere> packSpheres(const AgentStore& agents, Index none) {
  std::vector<Sphere> spheres(none + std::size_t{1}, {0, 0, 0, noAgentRadius});
  for (Index i = 0; i < agents.size(); ++i)
    spheres[i] = {agents.x[i], agents.y[i], agents.z[i], agents.radius[i]};
  return spheres;
}

std::vector<FixedSphere> packSpheres(const AgentStore& agents, Index none, const FixedScale& scale) {
  std::vector<FixedSphere> spheres(none + std::size_t{1}, fixedSphere(scale, Vec3::Zero(), noAgentRadius));
  for (Index i = 0; i < agents.size(); ++i)
    spheres[i] = fixedSphere(scale, agents.position(i), static_cast<float>(agents.radius[i]));
  return spheres;
}

}  // namespace restenosis

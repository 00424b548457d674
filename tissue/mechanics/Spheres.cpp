#include "Spheres.h"

#include <cmath>

namespace restenosis {

FixedScale::FixedScale(double radius)
    : unit_(std::exp2(std::floor(std::log2(radius)) - 22)), perUnit_(1 / unit_) {}

std::uint32_t FixedScale::wholeOfFar(double units) {
  constexpr double period = 4294967296.0;
  const double within = std::isfinite(units) ? std::fmod(units, period) : 0;
  return static_cast<std::uint32_t>(static_cast<std::int64_t>(within));
}

std::vector<Sphere> packSpheres(const AgentStore& agents, Index nobody) {
  std::vector<Sphere> spheres(nobody + std::size_t{1}, {0, 0, 0, noAgentRadius});
  for (Index i = 0; i < agents.size(); ++i)
    spheres[i] = {agents.x[i], agents.y[i], agents.z[i], agents.radius[i]};
  return spheres;
}

std::vector<FixedSphere> packSpheres(const AgentStore& agents, Index nobody, const FixedScale& scale) {
  std::vector<FixedSphere> spheres(nobody + std::size_t{1}, scale.of(Vec3::Zero(), noAgentRadius));
  for (Index i = 0; i < agents.size(); ++i) spheres[i] = scale.of(agents.position(i), agents.radius[i]);
  return spheres;
}

}  // namespace restenosis

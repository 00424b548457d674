#include "NitricOxide.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "ParallelThreshold.h"

namespace restenosis {

NitricOxide::NitricOxide(const EndotheliumParameters& parameters) : p_(parameters) {
  const double vertex = -p_.nitricOxideFirst / (2 * p_.nitricOxideSecond);
  const double atTransition = p_.nitricOxideSlope * p_.nitricOxideTransition;
  if (vertex > p_.nitricOxideTransition && parabola(p_.nitricOxideTransition) > atTransition) {
    throw std::invalid_argument(
        "endothelium: nitric oxide would fall with wall shear stress above nitricOxideTransition: "
        "-nitricOxideFirst / (2 nitricOxideSecond) must not exceed nitricOxideTransition, "
        "or the parabola there not exceed nitricOxideSlope times it");
  }
}

double NitricOxide::parabola(double wss) const {
  return (p_.nitricOxideSecond * wss + p_.nitricOxideFirst) * wss + p_.nitricOxideConstant;
}

double NitricOxide::concentration(double wss) const {
  if (!(wss > 0)) return 0;
  if (wss <= p_.nitricOxideTransition) return p_.nitricOxideSlope * wss;
  return std::max(p_.nitricOxideSlope * p_.nitricOxideTransition, parabola(wss));
}

double NitricOxide::wssForNitricOxide(double threshold) const {
  if (threshold <= 0) return 0;
  if (threshold <= p_.nitricOxideSlope * p_.nitricOxideTransition) return threshold / p_.nitricOxideSlope;
  const double first = p_.nitricOxideFirst, second = p_.nitricOxideSecond;
  const double discriminant = first * first - 4 * second * (p_.nitricOxideConstant - threshold);
  const double root = (-first + std::sqrt(std::max(0.0, discriminant))) / (2 * second);
  return std::max(root, p_.nitricOxideTransition);
}

void NitricOxide::apply(AgentStore& agents) const {
#pragma omp parallel for schedule(static) if (agents.size() > parallelThreshold)
  for (Index i = 0; i < agents.size(); ++i) {
    const bool produces = agents.kind[i] == AgentKind::smc && agents.has(i, covered);
    agents.nitricOxide[i] = produces ? concentration(agents.wss[i]) : 0.0;
  }
}

}  // namespace restenosis

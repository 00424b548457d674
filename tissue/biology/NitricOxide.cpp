#include "tissue/biology/NitricOxide.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "tissue/agents/Chunks.h"
#include "tissue/biology/NitricOxideSpread.h"

namespace restenosis {

namespace {

// Of the threshold. Nitric oxide that reaches a cell is 0 below that.
constexpr double negligibleShare = 0.01;

double parabola(const EndotheliumParameters& p, double wss) {
  return (p.nitricOxideSecond * wss + p.nitricOxideFirst) * wss + p.nitricOxideConstant;
}

}  // namespace

std::string NitricOxide::problem(const EndotheliumParameters& p) {
  const double vertex = -p.nitricOxideFirst / (2 * p.nitricOxideSecond);
  const double atTransition = p.nitricOxideSlope * p.nitricOxideTransition;
  if (vertex <= p.nitricOxideTransition || parabola(p, p.nitricOxideTransition) <= atTransition) return {};
  return fmt::format(
      "nitric oxide would fall with wall shear stress above 'nitricOxideTransition' = {:.4g} Pa, where the "
      "parabola is {:.4g} nmol/mm^3 and falls until {:.4g} Pa: set 'nitricOxideTransition' to at least that, "
      "or 'nitricOxideSlope' so that it gives no less there (now {:.4g} nmol/mm^3)",
      p.nitricOxideTransition, parabola(p, p.nitricOxideTransition), vertex, atTransition);
}

NitricOxide::NitricOxide(const EndotheliumParameters& parameters) : p_(parameters) {
  if (const std::string wrong = problem(p_); !wrong.empty())
    throw std::invalid_argument("endothelium: " + wrong);
}

double NitricOxide::concentration(double wss) const {
  if (!(wss > 0)) return 0;
  if (wss <= p_.nitricOxideTransition) return p_.nitricOxideSlope * wss;
  return std::max(p_.nitricOxideSlope * p_.nitricOxideTransition, parabola(p_, wss));
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
  forEachInChunks(agents.size(), [&](std::size_t k) {
    const auto i = static_cast<Index>(k);
    const bool produces = agents.kind[i] == AgentKind::smc && agents.has(i, covered);
    agents.nitricOxide[i] = produces ? concentration(agents.wss[i]) : 0.0;
    if (agents.maturity.modelled()) agents.nitricOxide[i] *= agents.maturity[i];
  });
  if (p_.nitricOxideReach > 0)
    spreadNitricOxide(agents, p_.nitricOxideReach, negligibleShare * p_.nitricOxideThreshold);
}

}  // namespace restenosis

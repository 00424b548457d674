#include "tissue/vessel/TableLayers.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "tissue/parameters/LengthUnits.h"
#include "tissue/vessel/Cylindrical.h"
#include "tissue/vessel/RadiusMap.h"

namespace restenosis {
namespace {

/// The EEL's agents by z, to find whether any is near a place.
class EelAgents {
 public:
  explicit EelAgents(const AgentStore& agents) {
    for (Index i = 0; i < agents.size(); ++i)
      if (agents.kind[i] == AgentKind::eel) places_.push_back(agents.position(i));
    std::ranges::sort(places_, {}, along);
  }
  bool near(const Vec3& place, double reach) const {
    const auto first = std::ranges::lower_bound(places_, place.z() - reach, {}, along);
    const auto last = std::ranges::upper_bound(places_, place.z() + reach, {}, along);
    return std::any_of(first, last, [&](const Vec3& p) { return (p - place).norm() < reach; });
  }

 private:
  static double along(const Vec3& place) { return place.z(); }

  std::vector<Vec3> places_;
};

}  // namespace

void requireInsideEel(const AgentTable& table, double cellRadius) {
  const AgentStore& agents = table.agents;
  const double smoothing = 2 * cellRadius;  // as OuterConfinement has it
  const RadiusMap eel(agents, AgentKind::eel, smoothing);
  if (eel.empty()) return;
  const EelAgents itsAgents(agents);
  for (Index i = 0; i < agents.size(); ++i) {
    if (agents.kind[i] != AgentKind::smc && agents.kind[i] != AgentKind::iel) continue;
    const Vec3 position = agents.position(i);
    const double distance = radiusOf(position), beyond = std::max(cellRadius, agents.radius[i]);
    if (distance <= eel.lowest() + beyond) continue;
    const double surface = eel.at(position);
    if (distance <= surface + beyond || !itsAgents.near(atRadius(position, surface), 3 * smoothing)) continue;
    table.fail(
        i, fmt::format("an agent of kind {} outside the EEL: its centre is {:.6g} um from the axis (x = y "
                       "= 0), the EEL there {:.6g} um, which no cell leaves through; allowed are at most "
                       "{:.6g} um, a radius beyond it",
                       agents.kind[i] == AgentKind::smc ? "smc" : "iel", distance / um, surface / um,
                       (surface + beyond) / um));
  }
}

}  // namespace restenosis

#include "tissue/stent/DeploymentStatistics.h"

#include <algorithm>

#include "tissue/neighbours/NeighbourQuery.h"
#include "tissue/stent/StrutFootprint.h"
#include "tissue/vessel/Cylindrical.h"
#include "tissue/vessel/RadiusMap.h"

namespace restenosis {
namespace {

class Mean {
 public:
  void add(double value) { sum_ += value, ++count_; }
  std::optional<double> value() const {
    if (count_ == 0) return std::nullopt;
    return sum_ / static_cast<double>(count_);
  }

 private:
  double sum_ = 0;
  std::size_t count_ = 0;
};

void measureStruts(const Wall& wall, const Stent& stent, DeploymentStatistics& result) {
  const AgentStore& agents = wall.agents;
  const StrutFootprint footprint(stent);
  Mean iel, eel;
  for (Index i = 0; i < agents.size(); ++i) {
    if (agents.kind[i] == AgentKind::strut) continue;
    const Vec3 position = agents.position(i);
    const double radius = radiusOf(position);
    bool inPath = false, lumenward = false, passed = false, under = false;
    const double margin = wall.cellRadius / 2;
    footprint.visit(position, margin, [&](const StrutFootprint::Hit& hit) {
      inPath = true;
      lumenward = lumenward || radius < hit.outerFace;
      passed = passed || radius < hit.outerFace - margin;
      under = under || hit.across < stent.segments[hit.segment].width / 4;
    });
    const bool free = !agents.has(i, fixed);
    result.freeInPath += inPath && free;
    result.escaped += lumenward;
    result.escapedFree += lumenward && free;
    result.passedFree += passed && free;
    if (under && agents.kind[i] == AgentKind::iel) iel.add(radius);
    if (under && agents.kind[i] == AgentKind::eel) eel.add(radius);
  }
  result.ielUnderStrut = iel.value();
  if (iel.value() && eel.value()) result.laminaDistance = *eel.value() - *iel.value();
}

void measureOverlap(const Wall& wall, DeploymentStatistics& result) {
  const AgentStore& agents = wall.agents;
  if (agents.size() == 0) return;
  const CellGrid grid(agents, 2 * NeighbourQuery::largestRadius(agents));
  NeighbourQuery query(agents, grid);
  for (Index i = 0; i < agents.size(); ++i) {
    if (agents.kind[i] == AgentKind::strut) continue;
    query.forEachNeighbour(i, 1, [&](Index j, double distance) {
      const double overlap = agents.radius[i] + agents.radius[j] - distance;
      result.largestOverlap = std::max(result.largestOverlap, overlap / wall.cellRadius);
    });
  }
}

void measureBonds(const Wall& wall, DeploymentStatistics& result) {
  const AgentStore& agents = wall.agents;
  Mean all, lamina;
  for (Index i = 0; i < wall.bonds.size(); ++i) {
    for (const Bond& bond : wall.bonds.of(i)) {
      if (bond.partner < i) continue;
      const double strain =
          (agents.position(i) - agents.position(bond.partner)).norm() / bond.restLength - 1.0;
      all.add(strain);
      result.largestStrain = std::max(result.largestStrain, strain);
      if (agents.kind[i] != AgentKind::iel || agents.kind[bond.partner] != AgentKind::iel) continue;
      lamina.add(strain);
      result.largestIelStrain = std::max(result.largestIelStrain, strain);
    }
  }
  result.meanStrain = all.value();
  result.meanIelStrain = lamina.value();
}

}  // namespace

DeploymentStatistics measureDeployment(const Wall& wall, const Stent& stent) {
  DeploymentStatistics result;
  measureStruts(wall, stent, result);
  measureOverlap(wall, result);
  measureBonds(wall, result);
  const RadiusMap eel(wall.agents, AgentKind::eel, 2 * wall.cellRadius);
  for (Index i = 0; i < wall.agents.size(); ++i) {
    if (wall.agents.kind[i] != AgentKind::smc) continue;
    const Vec3 position = wall.agents.position(i);
    result.outside += radiusOf(position) > eel.at(position);
  }
  return result;
}

}  // namespace restenosis

#include "tissue/stent/EscapedAgents.h"

#include <fmt/format.h>

namespace restenosis {
namespace {

/// Share of the free agents in the path of struts that may be left behind (assumed).
constexpr double toleratedShare = 0.1;

/// Struts move before the wall does, so a step must be short against the cells.
std::string finerSteps(int deploymentSteps) {
  return fmt::format("raise stent.deploymentSteps (now {})", deploymentSteps);
}

}  // namespace

bool strutsWentThrough(const DeploymentStatistics& wall) {
  return wall.passedFree > toleratedShare * wall.freeInPath;
}

std::string remarkOnEscaped(const DeploymentStatistics& wall, int deploymentSteps) {
  if (wall.escaped == 0) return {};
  std::string text = fmt::format(
      "after deployment {} of the agents in the path of struts {} on their lumenward side:", wall.escaped,
      wall.escaped == 1 ? "is" : "are");
  if (wall.passedFree > 0)
    text += fmt::format(" {} free, of which struts have passed {}, {};", wall.escapedFree, wall.passedFree,
                        finerSteps(deploymentSteps));
  else if (wall.escapedFree > 0)
    text += fmt::format(
        " {} free, none by more than half a cell radius: contacts as soft as these let struts sink in so "
        "far;",
        wall.escapedFree);
  if (const Index held = wall.escaped - wall.escapedFree; held > 0)
    text += fmt::format(
        " {} fixed, so that they cannot move, lower vessel.fixedEnds or keep struts away from the ends;",
        held);
  text.pop_back();
  return text;
}

void requireWallOutsideStruts(const DeploymentStatistics& wall, int deploymentSteps) {
  if (!strutsWentThrough(wall)) return;
  throw DeploymentFailed(fmt::format(
      "the struts went through the wall instead of pressing it outwards: {} of the {} agents in their "
      "path that are free to move are lumenward of their outer faces by more than half a cell radius; {}",
      wall.passedFree, wall.freeInPath, finerSteps(deploymentSteps)));
}

}  // namespace restenosis

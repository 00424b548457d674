#include "Deployment.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "BondTurnover.h"
#include "EndPlanes.h"
#include "OuterConfinement.h"

namespace restenosis {

Deployment::Deployment(Wall& wall, Stent stent, const StentParameters& parameters,
                       const VesselParameters& vessel, const MechanicsParameters& mechanics, int stepsDone)
    : wall_(wall),
      undeployed_(std::move(stent)),
      relaxation_(mechanics, vessel.cellRadius),
      bondStrainLimit_(mechanics.bondStrainLimit),
      depth_(parameters.deploymentDepth),
      steps_(static_cast<int>(parameters.deploymentSteps)),
      stepsDone_(stepsDone) {
  attachStruts();
  if (stepsDone == 0) fixAgents(parameters, vessel);
  placeStent();
}

double Deployment::depthAfter(int k) const { return k == steps_ ? depth_ : depth_ * k / steps_; }

void Deployment::attachStruts() {
  AgentStore& agents = wall_.agents;
  for (Index i = 0; i < agents.size(); ++i) {
    if (agents.kind[i] == AgentKind::strut) strutAgents_.push_back(i);
  }
  if (strutAgents_.empty()) {
    for (std::size_t n = 0; n < undeployed_.spheres.size(); ++n) {
      strutAgents_.push_back(
          agents.append(AgentKind::strut, undeployed_.centre(n), undeployed_.spheres[n].radius));
    }
    wall_.bonds.resize(agents.size());
  }
  if (strutAgents_.size() != undeployed_.spheres.size()) {
    throw std::invalid_argument(fmt::format("the wall holds {} strut agents, but the stent has {}",
                                            strutAgents_.size(), undeployed_.spheres.size()));
  }
}

void Deployment::fixAgents(const StentParameters& parameters, const VesselParameters& vessel) {
  fixEnds(wall_, vessel.fixedEnds);
  for (const Index i : strutAgents_) wall_.agents.set(i, fixed, true);
  if (parameters.outerLamina == "fixed") fixOuterLamina(wall_);
}

void Deployment::placeStent() {
  stent_ = undeployed_.movedOutwards(depthAfter(stepsDone_));
  for (std::size_t n = 0; n < strutAgents_.size(); ++n) {
    wall_.agents.setPosition(strutAgents_[n], stent_.centre(n));
  }
}

RelaxationReport Deployment::step() {
  ++stepsDone_;
  continueLastMove();
  placeStent();
  const EndPlanes ends(wall_.length);
  const OuterConfinement outside(wall_.agents, wall_.cellRadius);
  const std::array<const Constraint*, 2> constraints = {&outside, &ends};
  RelaxationReport report = relaxation_.relax(wall_.agents, wall_.bonds, constraints);
  while (breakStrainedBonds(wall_.agents, wall_.bonds, bondStrainLimit_) > 0)
    report.goOnWith(relaxation_.relax(wall_.agents, wall_.bonds, constraints));
  for (Index i = 0; i < wall_.agents.size(); ++i) {
    const Vec3 move = wall_.agents.position(i) - lastMoveOf(i);
    std::ranges::copy(move, wall_.lastMove.begin() + 3 * static_cast<std::ptrdiff_t>(i));
  }
  return report;
}

Vec3 Deployment::lastMoveOf(Index i) const { return Vec3::Map(&wall_.lastMove[3 * std::size_t{i}]); }

void Deployment::continueLastMove() {
  // Steps are equal, so the wall will move much as it did in the last one: starting there, the relaxation has
  // only the difference to find. Where that is does not change; how soon it is found does.
  AgentStore& agents = wall_.agents;
  const bool known = wall_.lastMove.size() == 3 * std::size_t{agents.size()};
  wall_.lastMove.resize(3 * std::size_t{agents.size()});
  for (Index i = 0; i < agents.size(); ++i) {
    const Vec3 before = agents.position(i);
    if (known && agents.kind[i] != AgentKind::strut && !agents.has(i, fixed))
      agents.setPosition(i, before + lastMoveOf(i));
    // Where it began, until the step is over: the same memory does.
    std::ranges::copy(before, wall_.lastMove.begin() + 3 * static_cast<std::ptrdiff_t>(i));
  }
}

void Deployment::run(const std::function<void(const Deployment&, const RelaxationReport&)>& progress) {
  while (!done()) {
    const RelaxationReport report = step();
    if (progress) progress(*this, report);
  }
}

}  // namespace restenosis

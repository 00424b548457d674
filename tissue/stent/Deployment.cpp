#include "tissue/stent/Deployment.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>
#include <utility>
#include <vector>

#include "tissue/forces/BondTurnover.h"
#include "tissue/vessel/EndPlanes.h"
#include "tissue/vessel/OuterConfinement.h"

namespace restenosis {
namespace {

/// The three numbers of agent i.
std::span<double> vectorOf(std::vector<double>& values, Index i) {
  return std::span(values).subspan(3 * std::size_t{i}, 3);
}

/// Aims at `stepShare` of the tolerance, as far as the iterations suffice; a fixed effort is unchanged.
RelaxationParameters aimed(RelaxationParameters relaxation) {
  if (!relaxation.stopAtMaximum) relaxation.tolerance *= Deployment::stepShare;
  relaxation.stopAtMaximum = true;
  return relaxation;
}

}  // namespace

Deployment::Deployment(Wall& wall, Stent stent, const StentParameters& parameters,
                       const VesselParameters& vessel, const MechanicsParameters& mechanics,
                       const RelaxationParameters& relaxation, int stepsDone)
    : wall_(wall),
      undeployed_(std::move(stent)),
      mechanics_(mechanics),
      asked_(relaxation),
      relaxation_(mechanics, aimed(relaxation), vessel.cellRadius),
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
  if (parameters.fixesOuterLamina()) fixOuterLamina(wall_);
}

void Deployment::placeStent() {
  stent_ = undeployed_.movedOutwards(depthAfter(stepsDone_));
  for (std::size_t n = 0; n < strutAgents_.size(); ++n) {
    wall_.agents.setPosition(strutAgents_[n], stent_.centre(n));
  }
}

RelaxationReport Deployment::step() {
  ++stepsDone_;
  const AgentStore& agents = wall_.agents;
  std::vector<double> moves = continueLastMove();
  placeStent();
  RelaxationReport report = relaxBy(relaxation_);
  if (!report.converged && !asked_.stopAtMaximum) {
    // Missing the aim is accepted, missing the scene's tolerance is not
    Relaxation asked(mechanics_, asked_, wall_.cellRadius);
    report.append(relaxBy(asked));
  }
  for (Index i = 0; i < agents.size(); ++i) {
    const auto ofAgent = vectorOf(moves, i);
    const Vec3 move = agents.position(i) - Vec3::Map(ofAgent.data());
    std::ranges::copy(move, ofAgent.begin());
  }
  wall_.lastMove = std::move(moves);
  return report;
}

RelaxationReport Deployment::relaxBy(Relaxation& relaxation) {
  const EndPlanes ends(wall_.length);
  const OuterConfinement outside(wall_.agents, wall_.cellRadius);
  const std::array<const Constraint*, 2> constraints = {&outside, &ends};
  RelaxationReport report = relaxation.relax(wall_.agents, wall_.bonds, constraints);
  while (breakStrainedBonds(wall_.agents, wall_.bonds, mechanics_.bondStrainLimit) > 0)
    report.append(relaxation.relax(wall_.agents, wall_.bonds, constraints));
  return report;
}

std::vector<double> Deployment::continueLastMove() {
  // Initial guess: steps are equal, so the wall moves much as in the last one, and the relaxation has only
  // the difference to find. The equilibrium does not change, only the number of iterations.
  AgentStore& agents = wall_.agents;
  std::vector<double> values = std::exchange(wall_.lastMove, {});
  const bool known = values.size() == 3 * std::size_t{agents.size()};
  values.resize(3 * std::size_t{agents.size()});
  for (Index i = 0; i < agents.size(); ++i) {
    const auto ofAgent = vectorOf(values, i);
    const Vec3 before = agents.position(i);
    if (known && agents.kind[i] != AgentKind::strut && !agents.has(i, fixed))
      agents.setPosition(i, before + Vec3::Map(ofAgent.data()));
    std::ranges::copy(before, ofAgent.begin());
  }
  return values;
}

void Deployment::run(const std::function<void(const Deployment&, const RelaxationReport&)>& progress) {
  while (!done()) {
    const RelaxationReport report = step();
    if (progress) progress(*this, report);
  }
}

}  // namespace restenosis

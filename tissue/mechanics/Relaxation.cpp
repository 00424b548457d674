#include "Relaxation.h"

#include <fmt/format.h>

#include "Minimiser.h"
#include "RelaxingAgents.h"

namespace restenosis {
namespace {

// Agents beside moving ones are looked at this often: seldom enough to cost little, often enough that what
// they add is not missed for long.
constexpr int iterationsBetweenWaking = 5;

// Seldom, so that those who have come to rest for a moment are not taken to be at rest.
constexpr int iterationsBetweenRetiring = 25;

// Agents that move are brought this far below the tolerance that wakes others: those just below it would be
// woken again by the next small change.
constexpr double settledShare = 0.9;

// Least stiffness an agent is given, over C r0: that of a contact 2 % of the radius deep. It bounds the step
// of agents that are hardly touched.
constexpr double softestContact = 1.2;

// Mixed precision errs by some 10^-6 of the forces on an agent, which may be a hundred times C r0^2.
constexpr double leastMixedTolerance = 1e-3;

// How far beyond contact the neighbour list looks, over r0. Speed only: results do not depend on it.
constexpr double skinOverRadius = 0.4;

}  // namespace

Relaxation::Relaxation(const MechanicsParameters& parameters, double referenceRadius)
    : parameters_(parameters),
      field_(parameters),
      referenceRadius_(referenceRadius),
      characteristicForce_(parameters.contactModulus * referenceRadius * referenceRadius) {
  makeMinimiser(parameters);  // an unknown name is an error now, not at the first relaxation
}

std::optional<FixedScale> Relaxation::scaleFor(const AgentStore& agents, const BondTable& bonds) const {
  if (parameters_.precision == "double") return std::nullopt;
  if (parameters_.precision == "automatic" && parameters_.tolerance < leastMixedTolerance)
    return std::nullopt;
  const FixedScale scale(referenceRadius_);
  const double within = scale.reach() / 4;
  for (Index i = 0; i < agents.size(); ++i) {
    if (agents.radius[i] > within) return std::nullopt;
    for (const Bond& bond : bonds.of(i)) {
      if ((agents.position(i) - agents.position(bond.partner)).norm() > within) return std::nullopt;
    }
  }
  return scale;
}

Index Relaxation::agentsBeyondLaw(const AgentStore& agents) const {
  Index count = 0;
  for (Index i = 0; i < agents.size(); ++i) {
    count += agents.kind[i] != AgentKind::strut && field_.overlapOverValid(agents, neighbours_, i) > 1;
  }
  return count;
}

RelaxationReport Relaxation::relax(AgentStore& agents, const BondTable& bonds,
                                   std::span<const Constraint* const> constraints) {
  const double tolerance = parameters_.tolerance * characteristicForce_;
  RelaxingAgents relaxing(agents, bonds, constraints, field_,
                          softestContact * parameters_.contactModulus * referenceRadius_, tolerance,
                          neighbours_, skinOverRadius * referenceRadius_, scaleFor(agents, bonds));
  const auto minimiser = makeMinimiser(parameters_);

  RelaxationReport report;
  report.converged = relaxing.allAsleep();
  while (!report.converged && report.iterations < parameters_.maximumIterations) {
    relaxing.advance(*minimiser);
    ++report.iterations;
    if (report.iterations % iterationsBetweenRetiring == 0) relaxing.retireQuiet(settledShare * tolerance);
    const bool quiet = relaxing.awakeResidual() <= settledShare * tolerance;
    const bool due = report.iterations % iterationsBetweenWaking == 0;
    const bool woken = (quiet || due) && relaxing.wakeDisturbed();
    report.converged = quiet && !woken && !relaxing.wakeAnyone();
  }
  if (!report.converged) relaxing.wakeAnyone();  // so that the residual reported is that of all agents
  report.residual = relaxing.residual() / characteristicForce_;
  report.agentEvaluations = relaxing.evaluations();
  if (!report.converged && !parameters_.stopAtMaximum) {
    throw RelaxationFailed(fmt::format(
        "the relaxation did not reach mechanics.tolerance = {} within mechanics.maximumIterations = {}: the "
        "force on "
        "agent {} is still {:.3g} times C r0^2. Allow more iterations or a larger tolerance, or set "
        "mechanics.stopAtMaximum = true to go on with what was reached",
        parameters_.tolerance, parameters_.maximumIterations, agents.id[relaxing.worstAgent()],
        report.residual));
  }
  return report;
}

}  // namespace restenosis

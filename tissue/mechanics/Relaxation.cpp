#include "Relaxation.h"

#include <fmt/format.h>

#include "Minimiser.h"
#include "RelaxingAgents.h"

namespace restenosis {
namespace {

// Agents beside moving ones are looked at this often: seldom enough to cost little, often enough that what
// they add is not missed for long.
constexpr int iterationsBetweenWaking = 5;

// Least stiffness an agent is given, over C r0: that of a contact 2 % of the radius deep. It bounds the step
// of agents that are hardly touched.
constexpr double softestContact = 1.2;

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

RelaxationReport Relaxation::relax(AgentStore& agents, const BondTable& bonds,
                                   std::span<const Constraint* const> constraints) {
  const double tolerance = parameters_.tolerance * characteristicForce_;
  RelaxingAgents relaxing(agents, bonds, constraints, field_,
                          softestContact * parameters_.contactModulus * referenceRadius_, tolerance,
                          neighbours_, skinOverRadius * referenceRadius_);
  const auto minimiser = makeMinimiser(parameters_);

  RelaxationReport report;
  report.converged = relaxing.allAsleep();
  while (!report.converged && report.iterations < parameters_.maximumIterations) {
    relaxing.advance(*minimiser);
    ++report.iterations;
    const bool quiet = relaxing.awakeResidual() <= tolerance;
    const bool due = report.iterations % iterationsBetweenWaking == 0;
    const bool woken = (quiet || due) && relaxing.wakeDisturbed();
    report.converged = quiet && !woken;
  }
  if (!report.converged) relaxing.wakeDisturbed();  // so that the residual reported is that of all agents
  relaxing.storePressures();
  report.residual = relaxing.residual() / characteristicForce_;
  report.agentEvaluations = relaxing.evaluations();
  report.agentsBeyondLaw = relaxing.agentsBeyondLaw();
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

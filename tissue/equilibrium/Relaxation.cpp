#include "tissue/equilibrium/Relaxation.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "tissue/equilibrium/AgentForces.h"
#include "tissue/equilibrium/Minimiser.h"
#include "tissue/equilibrium/RelaxingAgents.h"

namespace restenosis {
namespace {

// Agents at rest are sent to sleep, and those beside moving ones looked at, this often: seldom enough to cost
// little, often enough that what they add is not missed for long.
constexpr int iterationsBetweenReviews = 10;

// Agents that move are brought this far below the tolerance that wakes others. Were they left just below it,
// all that has moved would stay somewhat out of balance, and a growing wall would be looser than it is in
// equilibrium (docs/results/growth.md).
constexpr double settledShare = 0.1;

// Least stiffness an agent is given, over C r0: that of a contact 2 % of the radius deep. It bounds the step
// of agents that are hardly touched.
constexpr double softestContact = 1.2;

// Mixed precision errs by some 10^-6 of the forces on an agent, which would move it by less than a millionth
// of its radius: little beside a tenth of this.
constexpr double leastMixedTolerance = 5e-5;

/// What is said of a step limit that lets no agent go anywhere.
std::string shortSteps(const RelaxationParameters& p) {
  const double farthest = p.stepLimit * static_cast<double>(p.maximumIterations);
  if (farthest >= 1) return {};
  return fmt::format(" (with relaxation.stepLimit = {} no agent moves by more than {:.2g} radii in these)",
                     p.stepLimit, farthest);
}

}  // namespace

struct Relaxation::Standing {
  Standing(AgentStore& agents, const BondTable& bonds, std::span<const Constraint* const> constraints,
           const ForceField& field, NeighbourList& neighbours, const AgentForces::Settings& settings,
           double tolerance, bool sleeping)
      : forces(agents, bonds, constraints, field, neighbours, settings),
        relaxing(forces, tolerance, sleeping) {}

  AgentForces forces;
  RelaxingAgents relaxing;
};

Relaxation::Relaxation(const MechanicsParameters& mechanics, const RelaxationParameters& parameters,
                       double referenceRadius)
    : parameters_(parameters),
      field_(mechanics),
      contactModulus_(mechanics.contactModulus),
      referenceRadius_(referenceRadius) {
  makeMinimiser(parameters);  // an unknown name is an error now, not at the first relaxation
}

Relaxation::~Relaxation() = default;

std::optional<FixedScale> Relaxation::mixedScale() const {
  if (parameters_.precision == "double") return std::nullopt;
  if (parameters_.precision == "automatic" && parameters_.tolerance < leastMixedTolerance)
    return std::nullopt;
  return FixedScale(referenceRadius_);
}

RelaxationReport Relaxation::relax(AgentStore& agents, const BondTable& bonds,
                                   std::span<const Constraint* const> constraints) {
  standing_.reset();
  const RelaxationReport report = relaxAgain(agents, bonds, constraints);
  standing_.reset();
  return report;
}

RelaxationReport Relaxation::relaxAgain(AgentStore& agents, const BondTable& bonds,
                                        std::span<const Constraint* const> constraints) {
  // Should anything be thrown below, nothing is kept.
  std::unique_ptr<Standing> standing = std::move(standing_);
  if (standing) {
    standing->forces.refresh();
  } else {
    const AgentForces::Settings settings{.softest = softestContact * contactModulus_ * referenceRadius_,
                                         .skin = skinOverRadius * referenceRadius_,
                                         .scale = mixedScale()};
    standing = std::make_unique<Standing>(agents, bonds, constraints, field_, neighbours_, settings,
                                          parameters_.tolerance, parameters_.activeSet);
  }
  const RelaxationReport report = settle(*standing);
  if (report.converged) standing_ = std::move(standing);
  return report;
}

void Relaxation::forget() {
  standing_.reset();
  neighbours_ = NeighbourList();
}

RelaxationReport Relaxation::settle(Standing& standing) const {
  RelaxingAgents& relaxing = standing.relaxing;
  const std::uint64_t evaluationsBefore = standing.forces.evaluations();
  relaxing.begin(makeMinimiser(parameters_));

  RelaxationReport report;
  report.converged = relaxing.allAsleep();
  while (!report.converged && report.iterations < parameters_.maximumIterations) {
    if (meanwhile_) meanwhile_();
    relaxing.advance();
    ++report.iterations;
    // Waking one after another is a slow way to bring a long soft chain to rest, for example.
    if (report.iterations == parameters_.maximumIterations / 2) relaxing.wakeAll();
    const bool due = report.iterations % iterationsBetweenReviews == 0;
    const bool quiet = relaxing.allSettled(settledShare);
    // Before any retire: whoever moved is still awake, so no sleeper beside them is missed.
    const bool woken = (quiet || due) && relaxing.wakeDisturbed();
    if (due) relaxing.retireSettled(settledShare);
    report.converged = quiet && !woken && !relaxing.wakeAnyone();
  }
  // Less than was aimed at will do, but not less than the tolerance
  if (!report.converged) report.converged = !relaxing.wakeAnyone();
  report.residual = relaxing.residual();
  report.agentEvaluations = standing.forces.evaluations() - evaluationsBefore;
  if (!report.converged && !parameters_.stopAtMaximum) {
    const AgentId worst = standing.forces.agents().id[relaxing.farthestFromRest()];
    throw RelaxationFailed(
        fmt::format(
            "the relaxation did not reach relaxation.tolerance = {} within "
            "relaxation.maximumIterations = {}: agent {} would still move by {:.3g} of its radius{}. "
            "Allow more iterations or a larger tolerance, or set relaxation.stopAtMaximum = true to go "
            "on with what was reached",
            parameters_.tolerance, parameters_.maximumIterations, worst, report.residual,
            shortSteps(parameters_)),
        report, worst);
  }
  return report;
}

}  // namespace restenosis

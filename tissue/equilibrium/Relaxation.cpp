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
// equilibrium (docs/results/growth.md). Where many move, they bring each other farther than the most restless
// of them.
constexpr double settledShareOfFew = 0.02, settledShareOfMany = 0.15;
// Where nobody sleeps, this much is enough.
constexpr double settledShareOfAll = 0.9;

// Least stiffness an agent is given, over C r0: that of a contact 2 % of the radius deep. It bounds the step
// of agents that are hardly touched.
constexpr double softestContact = 1.2;

// Mixed precision errs by some 10^-6 of the forces on an agent, which may be a hundred times C r0^2; few
// agents settle at a fiftieth of the tolerance.
constexpr double leastMixedTolerance = 0.01;

// A force is more than another, both in single precision, above so many times that.
constexpr double longerThanRounded = 1 + 1e-6;

/// What is said of a step limit that lets no agent go anywhere.
std::string shortSteps(const RelaxationParameters& p) {
  const double farthest = p.stepLimit * static_cast<double>(p.maximumIterations);
  if (farthest >= 1) return {};
  return fmt::format(" (with relaxation.stepLimit = {} no agent moves by more than {:.2g} radii in these)",
                     p.stepLimit, farthest);
}

double settledShare(const RelaxingAgents& relaxing) {
  if (!relaxing.mayAnyoneSleep()) return settledShareOfAll;
  return relaxing.fewAreAwake() ? settledShareOfFew : settledShareOfMany;
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
      referenceRadius_(referenceRadius),
      characteristicForce_(mechanics.contactModulus * referenceRadius * referenceRadius) {
  makeMinimiser(parameters);  // an unknown name is an error now, not at the first relaxation
}

Relaxation::~Relaxation() = default;

std::optional<FixedScale> Relaxation::mixedScale() const {
  if (parameters_.precision == "double") return std::nullopt;
  // A daughter whom contacts hold softest may have to come to rest farther than the others settle.
  const double softest = RelaxingAgents::calmShare * softestContact / parameters_.firmStiffness;
  const double finer = std::min(1.0, softest / settledShareOfFew);
  if (parameters_.precision == "automatic" && finer * parameters_.tolerance < leastMixedTolerance)
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
    const AgentForces::Settings settings{
        .softest = softestContact * contactModulus_ * referenceRadius_,
        .firm = parameters_.firmStiffness * contactModulus_ * referenceRadius_,
        .skin = skinOverRadius * referenceRadius_,
        .scale = mixedScale()};
    standing = std::make_unique<Standing>(agents, bonds, constraints, field_, neighbours_, settings,
                                          parameters_.tolerance * characteristicForce_, parameters_.sleeping);
  }
  const RelaxationReport report = settle(*standing);
  if (report.converged) standing_ = std::move(standing);
  return report;
}

void Relaxation::forget() {
  standing_.reset();
  neighbours_ = NeighbourList();
}

int Relaxation::yield(RelaxingAgents& relaxing) const {
  // Everybody is woken half way through `maximumIterations`: that is yet to come
  const auto iterations =
      static_cast<int>(std::min(parameters_.yieldIterations, (parameters_.maximumIterations - 1) / 2));
  if (iterations == 0 || !relaxing.mayAnyoneSleep() || !relaxing.fewAreAwake()) return 0;
  std::unique_ptr<Minimiser> minimiser = makeMinimiser(parameters_);
  minimiser->setOutNearRest();
  if (!relaxing.wakeDaughtersAround(std::move(minimiser))) return 0;
  for (int n = 0; n < iterations; ++n) relaxing.advance();
  relaxing.placeAwake();
  relaxing.begin(makeMinimiser(parameters_));
  return iterations;
}

RelaxationReport Relaxation::settle(Standing& standing) const {
  RelaxingAgents& relaxing = standing.relaxing;
  const std::uint64_t evaluationsBefore = standing.forces.evaluations();
  relaxing.begin(makeMinimiser(parameters_));

  RelaxationReport report;
  report.iterations = yield(relaxing);
  report.converged = relaxing.allAsleep();
  while (!report.converged && report.iterations < parameters_.maximumIterations) {
    if (meanwhile_) meanwhile_();
    relaxing.advance();
    ++report.iterations;
    // Waking one after another is a slow way to bring a long soft chain to rest, for example.
    if (report.iterations == parameters_.maximumIterations / 2) relaxing.wakeAll();
    const double settled = settledShare(relaxing);
    const bool due = report.iterations % iterationsBetweenReviews == 0;
    const bool quiet = relaxing.allSettled(settled);
    // Before any retire: whoever moved is still awake, so no sleeper beside them is missed.
    const bool woken = (quiet || due) && relaxing.wakeDisturbed();
    if (due) relaxing.retireSettled(settled);
    report.converged = quiet && !woken && !relaxing.wakeAnyone();
  }
  if (!report.converged) relaxing.wakeAnyone();  // so that the residual reported is that of all agents
  report.residual = relaxing.residual() / characteristicForce_;
  report.agentEvaluations = standing.forces.evaluations() - evaluationsBefore;
  if (!report.converged && !parameters_.stopAtMaximum) {
    const auto [worst, on] = relaxing.mostRestless();
    const AgentId id = standing.forces.agents().id[worst];
    const double left = on.force.norm() / characteristicForce_;
    // What a daughter whom contacts hold softly may keep is less than the tolerance
    const double restless = on.restlessness / characteristicForce_;
    const std::string softly =
        restless > longerThanRounded * left
            ? fmt::format(" (of at most {:.3g}, for contacts hold it softly: relaxation.firmStiffness = {})",
                          parameters_.tolerance * left / restless, parameters_.firmStiffness)
            : "";
    throw RelaxationFailed(
        fmt::format(
            "the relaxation did not reach relaxation.tolerance = {} within relaxation.maximumIterations "
            "= {}: the force on agent {} is still {:.3g} times C r0^2{}{}. Allow more iterations or a "
            "larger tolerance{}, or set relaxation.stopAtMaximum = true to go on with what was reached",
            parameters_.tolerance, parameters_.maximumIterations, id, left, softly, shortSteps(parameters_),
            softly.empty() ? "" : " or a smaller relaxation.firmStiffness"),
        report, id, left);
  }
  return report;
}

}  // namespace restenosis

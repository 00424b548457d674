#include "tissue/equilibrium/Relaxation.h"

#include <fmt/format.h>

#include <utility>

#include "tissue/equilibrium/Equilibration.h"
#include "tissue/equilibrium/Minimiser.h"

namespace restenosis {
namespace {

// Least stiffness an agent is given, over C r0: that of a contact 2 % of the radius deep. It bounds the step
// of agents that are hardly touched.
constexpr double leastStiffness = 1.2;

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
  equilibration_.reset();
  const RelaxationReport report = relaxAgain(agents, bonds, constraints);
  equilibration_.reset();
  return report;
}

RelaxationReport Relaxation::relaxAgain(AgentStore& agents, const BondTable& bonds,
                                        std::span<const Constraint* const> constraints) {
  // Should anything be thrown below, nothing is kept.
  std::unique_ptr<Equilibration> equilibration = std::move(equilibration_);
  if (!equilibration) {
    const ForceCache::Settings settings{.leastStiffness = leastStiffness * contactModulus_ * referenceRadius_,
                                        .skin = skinOverRadius * referenceRadius_,
                                        .mixed = mixedScale()};
    equilibration = std::make_unique<Equilibration>(agents, bonds, constraints, field_, neighbours_, settings,
                                                    parameters_);
  }
  const RelaxationReport report = equilibration->run(beforeIteration_);
  if (!report.converged && !parameters_.stopAtMaximum) {
    const AgentId worst = agents.id[equilibration->worstAgent()];
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
  if (report.converged) equilibration_ = std::move(equilibration);
  return report;
}

void Relaxation::forget() {
  equilibration_.reset();
  neighbours_ = NeighbourList();
}

}  // namespace restenosis

// How far each method goes, step by step to its end: an error against what is known exactly, or a refusal.
// bench/run reads what these tests record.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bridge/flow/FlowBackend.h"
#include "bridge/flow/foam/FoamBackend.h"
#include "bridge/flow/lbm/LbmBackend.h"
#include "tests/support/CellCycles.h"
#include "tests/support/Constants.h"
#include "tests/support/FlowSupport.h"
#include "tests/support/LatticeSupport.h"
#include "tests/support/Mechanics.h"
#include "tests/support/OpenFoamPresent.h"
#include "tests/support/SmallDeployment.h"
#include "tests/support/TemporaryFolder.h"
#include "tests/support/TubeSurface.h"
#include "tissue/biology/CellCycle.h"
#include "tissue/biology/Division.h"
#include "tissue/equilibrium/Relaxation.h"
#include "tissue/stent/Deployment.h"
#include "tissue/stent/EscapedAgents.h"
#include "tissue/stent/StrutAgents.h"
#include "tissue/vessel/WallPacking.h"

namespace restenosis {
namespace {

using namespace support;

/// A test whose record is a curve: `quantity = value` and the error there, or why there is none.
class Limits : public ::testing::Test {
 protected:
  /// Requires what `measure` returns, a relative error, to be below `largest`; a refusal is one of `Refused`.
  template <class Refused, class Measure>
  void point(const std::string& quantity, double value, double largest, Measure&& measure) {
    const std::string name = fmt::format("{} = {:g}", quantity, value);
    try {
      const double error = measure();
      RecordProperty(name, fmt::format("{:.4g}", error));
      EXPECT_LT(error, largest) << name;
    } catch (const Refused& refused) {
      RecordProperty(name, "refused: " + std::string(refused.what()).substr(0, 200));
    }
  }
};

struct Never : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The mean stress of a tube by a backend, off from Poiseuille's law; an end of a tenth is left out.
double tubeError(FlowBackend& backend, double radius, double length, double velocity,
                 const std::filesystem::path& folder) {
  FlowConditions conditions = vesselConditions();
  conditions.flowRate = velocity * std::numbers::pi * radius * radius;
  const FlowSolution solved = backend.solve(tube(radius, length), conditions, folder);
  const double stress = 4 * conditions.density * conditions.kinematicViscosity * velocity / radius;
  return std::abs(stressError(solved, stress, 0.1 * length, 0.9 * length).mean);
}

constexpr double viscosity = 2.7e-6;  // [m^2/s], of vesselConditions
double velocityOf(double reynolds, double radius) { return reynolds * viscosity / (2 * radius); }
double narrowed(double percent) { return vesselRadius * std::sqrt(1 - percent / 100); }

const std::vector<double> reynoldsNumbers = {1e-6, 1e-3, 1, 10, 100, 300, 1000, 2000};
const std::vector<double> narrowings = {0, 50, 75, 90, 95, 98, 99, 99.5, 99.9};

TEST_F(Limits, ReynoldsNumberLattice) {
  LbmSettings settings = LbmSettings::forFidelity("draft");
  settings.dx = 2 * vesselRadius / 24;
  LbmBackend backend(settings);
  for (const double number : reynoldsNumbers)
    point<FlowFailed>("Reynolds number, lattice", number, 0.1, [&] {
      return tubeError(backend, vesselRadius, 0.6e-3, velocityOf(number, vesselRadius), {});
    });
}

TEST_F(Limits, ReynoldsNumberOpenFoam) {
  RESTENOSIS_NEEDS_OPENFOAM();
  FoamBackend backend(FoamSettings::forFidelity("draft"));
  for (const double number : reynoldsNumbers) {
    const TemporaryFolder scratch;
    point<FlowFailed>("Reynolds number, OpenFOAM", number, 0.1, [&] {
      return tubeError(backend, vesselRadius, 0.6e-3, velocityOf(number, vesselRadius), scratch / "case");
    });
  }
}

TEST_F(Limits, NarrowingLattice) {
  LbmBackend backend(LbmSettings::forFidelity("draft"));
  for (const double percent : narrowings) {
    const double radius = narrowed(percent);
    point<FlowFailed>("narrowing [%], lattice", percent, 0.2,
                      [&] { return tubeError(backend, radius, 0.4e-3, velocityOf(1, radius), {}); });
  }
}

TEST_F(Limits, NarrowingOpenFoam) {
  RESTENOSIS_NEEDS_OPENFOAM();
  FoamBackend backend(FoamSettings::forFidelity("draft"));
  for (const double percent : narrowings) {
    const TemporaryFolder scratch;
    const double radius = narrowed(percent);
    point<FlowFailed>("narrowing [%], OpenFOAM", percent, 0.2, [&] {
      return tubeError(backend, radius, 0.4e-3, velocityOf(1, radius), scratch / "case");
    });
  }
}

TEST_F(Limits, RelaxationTimeOfTheLattice) {
  for (const double tau : {0.502, 0.505, 0.52, 0.55, 0.7, 1.0, 2.0, 5.0, 10.0})
    point<Never>("relaxation time, lattice", tau, 0.2, [&] {
      LatticeRelaxation relaxation;
      relaxation.tau = tau;
      return periodicTube(16, WallRule::interpolated, relaxation, 0.01).stressRms;
    });
}

TEST_F(Limits, VelocityOfTheLattice) {
  for (const double velocity : {0.003, 0.01, 0.03, 0.1, 0.2, 0.3})
    point<FlowFailed>("lattice velocity", velocity, 0.1, [&] {
      LbmSettings settings = LbmSettings::forFidelity("draft");
      settings.dx = 2 * vesselRadius / 24;
      settings.latticeVelocity = velocity;
      LbmBackend backend(settings);
      return tubeError(backend, vesselRadius, 0.6e-3, meanVelocity, {});
    });
}

/// How far off the mean time is in which cells divide twice, of whole phases of 16.3 and 15.4 h.
double cycleError(double step) {
  const CellCycle cycle(phases(16.3 * hour, 15.4 * hour), 1, step);
  const Division division(1, 0.4);
  AgentStore agents;
  agents.append(AgentKind::smc, Vec3::Zero(), 15e-6);
  agents.set(0, synthetic, true);
  BondTable bonds;
  bonds.resize(1);
  const ArrestRules rules{BiologySettings{}};
  CycleReport report;
  int steps = 0;
  for (; agents.size() < 1024; ++steps) division.divide(agents, bonds, cycle.advance(agents, rules, report));
  // Ten cycles end in the step that holds their end
  return std::max(0.0, std::abs(steps * step - 10 * 31.7 * hour) - step) / (10 * 31.7 * hour);
}

TEST_F(Limits, StepOfTheCellCycle) {
  for (const double hours : {0.05, 0.25, 1.0, 4.0, 12.0, 24.0, 31.0, 48.0})
    point<Never>("step of the cell cycle [h]", hours, hours < 31.7 ? 1e-6 : 1,
                 [&] { return cycleError(hours * hour); });
}

TEST_F(Limits, OverlapOfAChain) {
  const double r = 15e-6;
  // From 50 % on, cells touch their next neighbours' neighbours, and equal spaces are no equilibrium any more
  for (const double percent : {0.1, 1.0, 10.0, 20.0, 30.0, 40.0, 49.0})
    point<RelaxationFailed>("overlap [% of a diameter]", percent, 0.01, [&] {
      MechanicsParameters mechanics;
      RelaxationParameters relaxation;
      relaxation.tolerance = 1e-6;
      const int spheres = 12;
      const double spacing = 2 * r * (1 - percent / 100);
      AgentStore agents;
      for (int k = 0; k < spheres; ++k) {
        const bool end = k == 0 || k == spheres - 1;
        agents.append(AgentKind::smc, {(k + (end ? 0 : 0.2 * (k % 2 == 0 ? 1 : -1))) * spacing, 0, 0}, r);
        agents.set(k, AgentFlag::fixed, end);
      }
      BondTable bonds;
      bonds.resize(agents.size());
      Relaxation(mechanics, relaxation, r).relax(agents, bonds, {});
      double largest = 0;
      for (int k = 0; k < spheres; ++k)
        largest = std::max(largest, (agents.position(k) - Vec3(k * spacing, 0, 0)).norm() / r);
      return largest;
    });
}

TEST_F(Limits, RadiusOfCells) {
  for (const double radius : {7.5, 10.0, 15.0, 22.5, 30.0, 45.0, 60.0, 90.0})
    point<std::invalid_argument>("cell radius [um]", radius, 0.2, [&] {
      VesselParameters vessel;
      vessel.length = 0.4e-3;
      vessel.cellRadius = 1e-6 * radius;
      PackingReport report;
      packWall(vessel, {}, {}, 1, &report);
      return report.rmsMove / vessel.cellRadius;
    });
}

TEST_F(Limits, StepsOfDeployment) {
  const auto innerRadius = [](int steps) {
    SmallDeployment s;
    s.stent.deploymentSteps = steps;
    Wall wall = packWall(s.vessel, s.mechanics, s.relaxation, 1);
    Deployment deployment(wall, stentOfDesign(s.stent, s.vessel), s.stent, s.vessel, s.mechanics,
                          s.relaxation);
    deployment.run([](const Deployment&, const RelaxationReport&) {});
    if (strutsWentThrough(deployment.statistics())) throw Never("struts went through the wall");
    double sum = 0;
    Index n = 0;
    for (Index i = 0; i < wall.agents.size(); ++i)
      if (wall.agents.kind[i] == AgentKind::iel) sum += std::hypot(wall.agents.x[i], wall.agents.y[i]), ++n;
    return sum / n;
  };
  const double reference = innerRadius(200), depth = SmallDeployment().stent.deploymentDepth;
  for (const int steps : {1, 2, 5, 10, 20, 50, 100})
    point<Never>("steps of deployment", steps, 0.1,
                 [&] { return std::abs(innerRadius(steps) - reference) / depth; });
}

}  // namespace
}  // namespace restenosis

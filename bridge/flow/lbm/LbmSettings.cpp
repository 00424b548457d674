#include "bridge/flow/lbm/LbmSettings.h"

#include <fmt/format.h>

#include <array>
#include <stdexcept>

#include "bridge/flow/lbm/WallStress.h"
#include "tissue/parameters/NamedTable.h"

namespace restenosis {
namespace {

struct Level {
  std::string_view fidelity;
  double dx;  // [m]
  double tolerance;
};
constexpr std::array levels = {Level{"draft", 25e-6, 5e-3}, Level{"standard", 20e-6, 2e-3},
                               Level{"reference", 15e-6, 1e-3}};

constexpr std::array collisions{Named<bool>{"trt", false}, Named<bool>{"bgk", true}};
constexpr std::array walls{Named<WallRule>{"interpolated", WallRule::interpolated},
                           Named<WallRule>{"bounceBack", WallRule::bounceBack}};
constexpr std::array stresses{Named<StressRule>{"adaptive", StressRule::adaptive},
                              Named<StressRule>{"nearest", StressRule::nearest}};
constexpr std::array precisions{Named<bool>{"double", false}, Named<bool>{"float", true}};

}  // namespace

bool LbmSettings::singleRelaxation() const { return findNamed(collisions, "lbm.collision", collision).value; }
WallRule LbmSettings::wallRule() const { return findNamed(walls, "lbm.wall", wall).value; }
StressRule LbmSettings::stressRule() const { return findNamed(stresses, "lbm.stress", stress).value; }
bool LbmSettings::singlePrecision() const { return findNamed(precisions, "lbm.precision", precision).value; }

void LbmSettings::describe(ParameterVisitor& p) {
  p.quantity(dx, {.key = "dx",
                  .unit = "um",
                  .minimum = 0,
                  .maximum = 10000,
                  .minimumAllowed = false,
                  .source = "T6",
                  .description = "lattice spacing"});
  p.choice(collision, namesOf(collisions),
           {.key = "collision", .source = "assumed", .description = "two relaxation times or one (T6)"});
  p.quantity(magic, {.key = "magic",
                     .minimum = 0,
                     .maximum = 10,
                     .minimumAllowed = false,
                     .source = "Ginzburg 2008",
                     .description = "(tau - 1/2)(tau of the odd parts - 1/2), for collision = \"trt\""});
  p.choice(
      wall, namesOf(walls),
      {.key = "wall", .source = "assumed", .description = "the wall where it is, or half a link away (T6)"});
  p.choice(
      stress, namesOf(stresses),
      {.key = "stress",
       .source = "assumed",
       .description = "fitted to the nodes around, by what the wall is like there (adaptive), or the nearest "
                      "node's stress as it is (nearest, T6)"});
  p.choice(precision, namesOf(precisions),
           {.key = "precision", .source = "assumed", .description = "of the populations"});
  p.quantity(latticeVelocity,
             {.key = "latticeVelocity",
              .minimum = 0,
              .maximum = 0.3,
              .minimumAllowed = false,
              .source = "assumed",
              .description = "largest expected velocity in spacings per time step; sets the time step"});
  p.quantity(
      tolerance,
      {.key = "tolerance",
       .minimum = 0,
       .maximum = 1,
       .minimumAllowed = false,
       .source = "assumed",
       .description = "distance of the wall shear stress from its steady state, estimated and relative, "
                      "at which the solution counts as converged"});
  p.integer(coarseLevels,
            {.key = "coarseLevels",
             .minimum = 0,
             .maximum = 8,
             .source = "assumed",
             .description = "lattices of twice, four times ... the spacing from which the solution starts"});
  p.boolean(warmStart, {.key = "warmStart",
                        .source = "docs/results/flow.md",
                        .description = "start from the former flow instead of from coarser lattices"});
  p.integer(maximumSteps,
            {.key = "maximumSteps", .minimum = 2, .source = "assumed", .description = "most time steps"});
  p.quantity(maximumNodes,
             {.key = "maximumNodes",
              .minimum = 1,
              .source = "assumed",
              .description = "lattice nodes in the box around the lumen above which it is refused"});
}

LbmSettings LbmSettings::forFidelity(std::string_view fidelity) {
  for (const Level& level : levels)
    if (level.fidelity == fidelity) {
      LbmSettings settings;
      settings.dx = level.dx;
      settings.tolerance = level.tolerance;
      return settings;
    }
  throw std::invalid_argument(
      fmt::format("there is no fidelity '{}'; valid names: draft, standard, reference", fidelity));
}

}  // namespace restenosis

#include "bridge/scene/RunParameters.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "tissue/parameters/NamedTable.h"

namespace restenosis {
namespace {

constexpr std::array schedules{Named<ScheduleMode>{"onChange", ScheduleMode::onChange},
                               Named<ScheduleMode>{"everyStep", ScheduleMode::everyStep}};
constexpr std::array stressUpdates{Named<bool>{"firstOrder", true}, Named<bool>{"none", false}};
constexpr std::array remeshings{Named<bool>{"always", false}, Named<bool>{"onDemand", true}};

struct Level {
  std::string_view fidelity;
  double lumenTolerance, lumenInterval;  // [m], [s]
};

/// Assumed; what tolerances cost and change is in docs/results/coupling.md.
constexpr std::array levels = {Level{"draft", 20e-6, 6 * 3600}, Level{"standard", 10e-6, 0},
                               Level{"reference", 5e-6, 0}};

constexpr std::array keysOfLevels = {"coupling.lumenTolerance", "coupling.lumenInterval"};

constexpr std::array keptFlowCases{Named<bool>{"last", false}, Named<bool>{"all", true}};

}  // namespace

ScheduleMode CouplingParameters::scheduleMode() const {
  return findNamed(schedules, "coupling.schedule", schedule).value;
}

bool CouplingParameters::stressFollowsLumen() const {
  return findNamed(stressUpdates, "coupling.stressUpdate", stressUpdate).value;
}

bool CouplingParameters::movesMesh() const { return findNamed(remeshings, "coupling.remesh", remesh).value; }

CouplingParameters CouplingParameters::forFidelity(std::string_view fidelity) {
  const auto level = std::ranges::find(levels, fidelity, &Level::fidelity);
  if (level == levels.end())
    throw std::invalid_argument(
        fmt::format("there is no fidelity '{}'; valid names: draft, standard, reference", fidelity));
  CouplingParameters settings;
  settings.lumenTolerance = level->lumenTolerance;
  settings.lumenInterval = level->lumenInterval;
  return settings;
}

bool CouplingParameters::followsFidelity(std::string_view name) {
  return std::ranges::find(keysOfLevels, name) != keysOfLevels.end();
}

bool OutputParameters::keepsAllFlowCases() const {
  return findNamed(keptFlowCases, "output.keepFlowCases", keepFlowCases).value;
}

void SceneParameters::describe(ParameterVisitor& p) {
  p.text(title, {.key = "title", .source = "none", .description = "a line for people"});
  p.quantity(duration, {.key = "duration",
                        .unit = "d",
                        .minimum = 0,
                        .maximum = 10000,
                        .minimumAllowed = false,
                        .required = true,
                        .source = "T6",
                        .description = "biological time to simulate"});
  p.quantity(step, {.key = "step",
                    .unit = "h",
                    .minimum = 0,
                    .maximum = 48,
                    .minimumAllowed = false,
                    .source = "T6",
                    .description = "biological step"});
  p.integer(seed,
            {.key = "seed", .minimum = 0, .source = "none", .description = "seed of all random numbers"});
  p.choice(fidelity, {"draft", "standard", "reference"},
           {.key = "fidelity",
            .source = "assumed",
            .description = "how finely the flow is solved and how often: what [foam], [lbm] and [coupling] "
                           "leave out"});
}

void CouplingParameters::describe(ParameterVisitor& p) {
  p.choice(schedule, namesOf(schedules),
           {.key = "schedule",
            .source = "model 9",
            .description = "solve the flow when its answer may have changed, "
                           "or at every step (T6)"});
  p.quantity(lumenTolerance,
             {.key = "lumenTolerance",
              .unit = "um",
              .minimum = 0,
              .maximum = 1000,
              .source = "assumed",
              .description = "movement of the lumen below which the last flow still holds; 20 um at "
                             "draft, 5 um at reference"});
  p.quantity(lumenInterval,
             {.key = "lumenInterval",
              .unit = "h",
              .minimum = 0,
              .maximum = 240,
              .source = "assumed",
              .description = "simulated time between two looks at the lumen, beside recorded steps and the "
                             "first solve; 0: in every step; 6 h at draft"});
  p.quantity(undecidedMargin,
             {.key = "undecidedMargin",
              .minimum = 0,
              .maximum = 1000,
              .source = "docs/developer/decisions.md",
              .description = "a covered cell below this times the arresting stress may decide otherwise "
                             "when the flow changes"});
  p.quantity(undecidedShare, {.key = "undecidedShare",
                              .minimum = 0,
                              .maximum = 1,
                              .source = "docs/developer/decisions.md",
                              .description = "share of these cells at which the lumen may have moved by more "
                                             "than lumenTolerance"});
  p.choice(stressUpdate, namesOf(stressUpdates),
           {.key = "stressUpdate",
            .source = "docs/model/coupling.md",
            .description = "how the stress on cells follows the lumen between two solves of the flow"});
  p.quantity(surfaceSmoothing, {.key = "surfaceSmoothing",
                                .unit = "um",
                                .minimum = 0,
                                .maximum = 500,
                                .source = "ISR3D",
                                .description = "cell scale at which the lumen surface is smoothed"});
  p.quantity(surfaceResolution,
             {.key = "surfaceResolution",
              .unit = "um",
              .minimum = 2,
              .maximum = 200,
              .source = "assumed",
              .description = "spacing of the distance field that the lumen is taken from; without "
                             "tissue there is none"});
  p.choice(
      remesh, namesOf(remeshings),
      {.key = "remesh",
       .source = "model 9",
       .description = "mesh each lumen afresh with snappyHexMesh, or move the last mesh while that is good "
                      "enough (foam)"});
}

void OutputParameters::describe(ParameterVisitor& p) {
  p.quantity(interval, {.key = "interval",
                        .unit = "d",
                        .minimum = 0,
                        .maximum = 10000,
                        .minimumAllowed = false,
                        .source = "none",
                        .description = "simulated time between recorded states"});
  p.quantity(checkpointInterval,
             {.key = "checkpointInterval",
              .unit = "d",
              .minimum = 0,
              .maximum = 10000,
              .minimumAllowed = false,
              .source = "none",
              .description = "simulated time between checkpoints, beside one about every 30 s of work"});
  p.choice(keepFlowCases, namesOf(keptFlowCases),
           {.key = "keepFlowCases", .source = "none", .description = "OpenFOAM cases to keep"});
  p.boolean(pictures, {.key = "pictures",
                       .source = "none",
                       .description = "draw PNG pictures and write report.html at the end"});
}

}  // namespace restenosis

#include "bridge/app/FlowTradeoff.h"

#include <fmt/format.h>

#include <iostream>
#include <optional>
#include <utility>

#include "bridge/app/ComparedLumen.h"
#include "bridge/app/RankOptions.h"
#include "bridge/compare/FlowComparison.h"
#include "bridge/coupling/FlowForecast.h"
#include "bridge/coupling/Run.h"
#include "bridge/flow/FlowBackendNames.h"
#include "bridge/flow/PoiseuilleError.h"
#include "bridge/flow/backends/FlowBackends.h"

namespace restenosis {
namespace {

/// A backend at a fidelity.
struct FlowChoice {
  std::string_view backend;
  const char* fidelity;
};

/// The reference first.
constexpr FlowChoice choices[] = {
    {flowBackendNames::foam, "reference"},    {flowBackendNames::foam, "standard"},
    {flowBackendNames::foam, "draft"},        {flowBackendNames::lbm, "reference"},
    {flowBackendNames::lbm, "standard"},      {flowBackendNames::lbm, "draft"},
    {flowBackendNames::analytic, "standard"},
};

// The law of Poiseuille knows no fidelity
bool hasFidelity(const FlowChoice& choice) { return choice.backend != flowBackendNames::analytic; }

std::string settingOf(const FlowChoice& choice) {
  return hasFidelity(choice) ? fmt::format("scene.fidelity ({})", choice.backend) : "flow.backend";
}

std::string valueOf(const FlowChoice& choice) {
  return std::string(hasFidelity(choice) ? choice.fidelity : choice.backend);
}

std::string nameOf(const FlowChoice& choice) {
  return hasFidelity(choice) ? fmt::format("{} {}", choice.backend, choice.fidelity)
                             : std::string(choice.backend);
}

/// The scene with one more override; it has been read without, so only this one can be wrong.
Scene sceneWith(SceneArguments arguments, const std::string& override) {
  arguments.overrides.push_back(override);
  auto scene = arguments.read();
  if (!scene) throw std::runtime_error(fmt::format("--set {} does not fit this scene", override));
  return *scene;
}

/// Whether two scenes ask the same of a backend: the keys that their fidelities would decide are given.
bool askTheSame(std::string_view backend, const Scene& a, const Scene& b) {
  if (backend == flowBackendNames::lbm) return a.lbmSettings() == b.lbmSettings();
  return backend == flowBackendNames::foam && a.foamSettings() == b.foamSettings();
}

}  // namespace

std::vector<TradeoffRow> flowTradeoff(const SceneArguments& arguments, const std::filesystem::path& folder,
                                      const TradeoffOptions& options) {
  const Scene scene = *arguments.read();
  const ComparedLumen lumen = scene.hasLoadedLumen() ? loadedLumen(scene)
                                                     : deployedLumen(scene, folder / "deployment",
                                                                     options.threads, options.stopRequested);
  const FlowConditions conditions = scene.flow->conditions(scene.vessel.lumenDiameter);
  const std::vector<Vec3> struts = strutMiddles(scene, lumen.alongZ);
  const bool exact = obeysPoiseuille(scene);
  std::vector<TradeoffRow> rows;
  std::optional<SolvedFlow> reference;
  std::optional<std::pair<FlowChoice, Scene>> last;
  for (const FlowChoice& choice : choices) {
    if (exact && !hasFidelity(choice)) continue;  // it is what the others are measured against
    const std::string name = nameOf(choice);
    const Scene chosen = sceneWith(arguments, fmt::format("scene.fidelity={}", choice.fidelity));
    if (last && last->first.backend == choice.backend && askTheSame(choice.backend, last->second, chosen)) {
      std::cerr << fmt::format(
          "{} is left out: the scene sets everything that scene.fidelity would, so it is the same as {}\n",
          name, nameOf(last->first));
      continue;
    }
    last.emplace(choice, chosen);
    std::cerr << fmt::format("{}: solving ...\n", name);
    const auto backend = makeFlowBackend(choice.backend, {.fidelity = choice.fidelity,
                                                          .foam = chosen.foam,
                                                          .lbm = chosen.lbm,
                                                          .straightEnds = chosen.flow->straightEnds,
                                                          .ranks = rankCount(chosen, options.ranks),
                                                          .stopRequested = options.stopRequested});
    SolvedFlow flow;
    try {
      flow =
          solveForComparison(*backend, lumen.surface, {}, conditions, folder / "flow" / withoutSpaces(name));
    } catch (const FlowFailed& error) {
      if (options.stopRequested && *options.stopRequested) throw Interrupted();
      if (!exact && !reference) throw;
      std::cerr << fmt::format("{} is left out: {}\n", name, error.what());
      continue;
    }
    if (!exact && !reference) reference = flow;
    TradeoffRow row{settingOf(choice), valueOf(choice), flow.seconds, 0.0, ""};
    if (exact) {
      const auto error =
          poiseuilleError(flow.solution.wall, scene.vessel.lumenDiameter, scene.vessel.length, conditions);
      if (!error) {
        std::cerr << fmt::format("{} is left out: the tube is too short to measure its error in\n", name);
        continue;
      }
      row.meaning = "wall shear stress (L2) against Poiseuille's law";
      row.error = error->l2;
    } else {
      row.meaning =
          fmt::format("wall shear stress (L2; struts and ends left out) against {}", nameOf(choices[0]));
      row.error = compareFlows(lumen.surface, {}, *reference, flow, struts).wall.relativeL2;
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace restenosis

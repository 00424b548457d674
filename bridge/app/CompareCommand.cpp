#include "bridge/app/CompareCommand.h"

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string_view>

#include "bridge/app/ComparedLumen.h"
#include "bridge/app/ExitStatus.h"
#include "bridge/app/Failures.h"
#include "bridge/app/OptionChecks.h"
#include "bridge/app/RankOptions.h"
#include "bridge/app/SceneArguments.h"
#include "bridge/app/StopRequest.h"
#include "bridge/app/ThreadCount.h"
#include "bridge/compare/ComparisonWriter.h"
#include "bridge/compare/ProbeTable.h"
#include "bridge/coupling/Run.h"
#include "bridge/flow/FlowBackendNames.h"
#include "bridge/flow/backends/FlowBackends.h"
#include "bridge/flow/foam/FoamRequirements.h"
#include "bridge/flow/foam/FoamTemplate.h"
#include "bridge/output/Figures.h"
#include "bridge/output/ResultsFolder.h"
#include "bridge/system/AtomicFile.h"

namespace restenosis {
namespace {

namespace fs = std::filesystem;

struct CompareArguments {
  SceneArguments scene;
  std::string folder, probes;
  std::optional<double> day;
  int threads = 0;
  int ranks = 0;
  bool ofResults() const { return fs::is_directory(scene.file); }
  bool writesIntoResults() const { return folder.empty() && ofResults(); }
};

fs::path outputFolder(const CompareArguments& arguments, const std::string& name) {
  if (!arguments.folder.empty()) return arguments.folder;
  return arguments.writesIntoResults() ? fs::path(arguments.scene.file) / "compare"
                                       : fs::path("results") / (name + "-compare");
}

void print(const FlowComparison& c, const SolvedFlow& reference, const SolvedFlow& other) {
  std::cout << fmt::format("\n{:<16}{:>10}{:>12}{:>12}{:>12}{:>12}{:>12}\n", "WSS", "mm^2",
                           reference.backend + " [Pa]", other.backend + " [Pa]", "mean [%]", "L2 [%]",
                           "p95 [%]");
  const auto row = [](std::string_view name, const FieldDifference& d) {
    if (d.count == 0) return;
    std::cout << fmt::format("{:<16}{:>10.3f}{:>12.4f}{:>12.4f}{:>12.2f}{:>12.2f}{:>12.2f}\n", name,
                             1e6 * d.weight, d.referenceMean, d.mean, 100 * d.meanDifference,
                             100 * d.relativeL2, 100 * d.relativeP95);
  };
  for (const ComparedPart part : comparedParts) row(partName(part), c.parts[static_cast<std::size_t>(part)]);
  if (c.hasVelocities && !c.lines.axis.empty()) {
    std::cout << fmt::format(
        "\nvelocity along the axis: {:.2f} % in L2; on {} planes:", 100 * c.axis.relativeL2, c.planes.size());
    for (const FieldDifference& d : c.planes) std::cout << fmt::format(" {:.2f}", 100 * d.relativeL2);
    std::cout << " %\n";
  }
  for (const SolvedFlow* flow : {&reference, &other}) {
    std::cout << fmt::format("{:<6}{:>10} cells, pressure drop {:.4f} Pa, {:.1f} s\n", flow->backend,
                             flow->solution.cells, flow->solution.pressureDrop, flow->seconds);
    for (const auto& remark : flow->solution.remarks) std::cout << fmt::format("      {}\n", remark);
  }
}

void nameFiles(const fs::path& folder) {
  std::cout << fmt::format("\n{}:\n", folder.string());
  for (const auto& [file, what] :
       {std::pair("compare.json", "all numbers"),
        std::pair("compare.vtp", "both fields and their difference: open in ParaView"),
        std::pair("compareVelocity.csv", "velocities on the axis and on planes"),
        std::pair("compareMaps.png", "picture"), std::pair("compareScatter.png", "picture"),
        std::pair("foam/case.foam", "OpenFOAM case: open in ParaView")})
    if (fs::exists(folder / file)) std::cout << fmt::format("  {:<20} {}\n", file, what);
}

/// What an earlier comparison has left; beside the flows of this one it would be taken for theirs.
void removeFormerComparison(const fs::path& folder) {
  for (const char* file :
       {"compare.json", "compare.vtp", "compareVelocity.csv", "compareMaps.png", "compareScatter.png"})
    fs::remove(folder / file);
}

/// `given`: the lumen, where no run has to make it.
int compare(const Scene& scene, const CompareArguments& arguments, const fs::path& folder,
            std::optional<ComparedLumen> given, const std::vector<Vec3>& probes) {
  // Said before a wall is packed and deployed for it
  const int ranks = rankCount(scene, arguments.ranks);
  if (const std::string missing = missingFoamProgram(ranks); !missing.empty()) throw FlowFailed(missing, {});
  if (const std::string missing = missingFoamTemplate(); !missing.empty()) throw FlowFailed(missing, {});
  // A run that starts in these results would move the comparison aside
  std::optional<ResultsFolder> compared;
  if (arguments.writesIntoResults() && ResultsFolder::isMarked(arguments.scene.file))
    compared.emplace(ResultsFolder::existing(arguments.scene.file));
  const auto results = ResultsFolder::forOutput(folder);
  removeFormerComparison(folder);
  const std::atomic<bool>* const stopRequested = &stopOnSignals();
  const int threads = threadCount(arguments.threads);
  omp_set_num_threads(threads);
  const ComparedLumen lumen =
      given ? std::move(*given) : deployedLumen(scene, folder / "deployment", threads, stopRequested);
  // Sections of a bent lumen are not planes of constant z
  ProbeLines lines = lumen.bent ? ProbeLines() : probeLines(lumen.surface);
  for (const Vec3& probe : probes) lines.others.push_back(lumen.alongZ * probe);
  const FlowConditions conditions = scene.flow->conditions(scene.vessel.lumenDiameter);
  const LbmSettings lbm = scene.lbmSettings();
  const FlowBackendOptions options{.fidelity = scene.scene.fidelity,
                                   .foam = scene.foam,
                                   .lbm = lbm,
                                   .straightEnds = scene.flow->straightEnds,
                                   .keepVelocities = true,
                                   .ranks = ranks,
                                   .stopRequested = stopRequested};
  const auto solve = [&](std::string_view name) {
    std::cerr << fmt::format("{}: solving in the lumen of day {:.4g} ...\n", name, lumen.day);
    const auto backend = makeFlowBackend(name, options);
    return solveForComparison(*backend, lumen.surface, lines, conditions, folder / name);
  };
  const SolvedFlow reference = solve(flowBackendNames::foam), other = solve(flowBackendNames::lbm);

  const FlowComparison result =
      compareFlows(lumen.surface, lines, reference, other, strutMiddles(scene, lumen.alongZ));
  const ComparedCase what{scene.name, scene.scene.fidelity, lumen.day, lbm.dx, lumen.bent, lumen.alongZ};
  writeComparisonJson(folder / "compare.json", what, result, reference, other);
  writeComparisonSurface(folder / "compare.vtp", lumen.surface, result, reference, other, what);
  writeComparedVelocities(folder / "compareVelocity.csv", result, reference, other, what);
  if (scene.output.pictures) {
    const std::string obstacle = Figures().draw(folder, &stopOnSignals());
    if (!obstacle.empty()) std::cerr << obstacle << '\n';
  }
  print(result, reference, other);
  nameFiles(folder);
  return ExitStatus::done;
}

/// Whether an override, SECTION.KEY=VALUE or SECTION=..., changes how the flow is solved. Nothing else can:
/// the lumen of a finished run is what it is.
bool changesTheFlow(std::string_view override) {
  const std::string_view name = override.substr(0, override.find('='));
  if (name == "scene.fidelity") return true;
  constexpr std::array<std::string_view, 4> ofTheFlow = {"flow", "foam", "lbm", "output"};
  return std::ranges::find(ofTheFlow, name.substr(0, name.find('.'))) != ofTheFlow.end();
}

int tryCompare(const CompareArguments& arguments) {
  SceneArguments sceneArguments = arguments.scene;
  const fs::path target = fs::absolute(arguments.scene.file).lexically_normal();
  if (arguments.ofResults()) {
    for (const std::string& override : sceneArguments.overrides) {
      if (changesTheFlow(override)) continue;
      std::cerr << fmt::format(
          "--set {}: the lumen of a finished run does not change; only [flow], [foam], [lbm], [output] and "
          "scene.fidelity can be set for it\n",
          override);
      return ExitStatus::wrongInput;
    }
    sceneArguments.file = target / "scene.toml";
  }
  auto scene = sceneArguments.read();
  if (!scene) return ExitStatus::wrongInput;
  if (arguments.ofResults()) scene->name = (target / "").parent_path().filename().string();
  if (!scene->flow) {
    std::cerr << fmt::format("{}: there is no [flow] to compare; add it with --set flow=present\n",
                             arguments.scene.file);
    return ExitStatus::wrongInput;
  }
  if (arguments.day && !arguments.ofResults()) {
    std::cerr << "--day chooses a lumen of a finished run: name its results folder instead of a scene\n";
    return ExitStatus::wrongInput;
  }
  return exitStatusOf(
      [&] {
        std::optional<ComparedLumen> given;  // refused before anything is written
        if (arguments.ofResults()) {
          given = finishedLumen(arguments.scene.file, arguments.day);
        } else if (scene->hasLoadedLumen()) {
          given = loadedLumen(*scene);
        }
        const auto probes = arguments.probes.empty() ? std::vector<Vec3>() : readProbes(arguments.probes);
        return compare(*scene, arguments, outputFolder(arguments, scene->name), std::move(given), probes);
      },
      {.interrupted = [](const Interrupted& end) { return std::string(end.what()); }});
}

}  // namespace

void addCompareCommand(CLI::App& app, int& status) {
  auto* command = app.add_subcommand(
      "compare", "solve the flow in one lumen by OpenFOAM and by the lattice Boltzmann method, side by side");
  auto arguments = std::make_shared<CompareArguments>();
  arguments->scene.addTo(*command);
  command->get_option("SCENE")->description(
      "scene file (TOML), for the lumen just after deployment, or the results folder of a run");
  command
      ->add_option("-o,--output", arguments->folder,
                   "folder for the comparison (default: results/<scene name>-compare, or compare/ in the "
                   "results folder)")
      ->check(aFolder());
  command
      ->add_option("--day", arguments->day,
                   "of the run's lumens, the one nearest to this day (default: the last)")
      ->check([](const std::string& text) {
        double day = 0;
        const bool finite = CLI::detail::lexical_cast(text, day) && std::isfinite(day);
        return finite ? std::string() : fmt::format("{} is not a day", text);
      });
  command->add_option("--probes", arguments->probes,
                      "table (CSV) of points, x_mm,y_mm,z_mm, whose velocities are written too");
  command->add_option("--threads", arguments->threads, "OpenMP threads (default: all cores)")
      ->check(countUpTo(mostThreads));
  addRankOptions(*command, arguments->ranks);
  command->callback([arguments, &status] { status = tryCompare(*arguments); });
}

}  // namespace restenosis

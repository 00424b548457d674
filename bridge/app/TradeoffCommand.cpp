#include "bridge/app/TradeoffCommand.h"

#include <fmt/format.h>
#include <omp.h>

#include <filesystem>
#include <iostream>
#include <memory>

#include "bridge/app/ComparedLumen.h"
#include "bridge/app/ExitStatus.h"
#include "bridge/app/Failures.h"
#include "bridge/app/FlowTradeoff.h"
#include "bridge/app/OptionChecks.h"
#include "bridge/app/RankOptions.h"
#include "bridge/app/RunTradeoff.h"
#include "bridge/app/SceneArguments.h"
#include "bridge/app/StopRequest.h"
#include "bridge/app/ThreadCount.h"
#include "bridge/coupling/Run.h"
#include "bridge/flow/FlowBackendNames.h"
#include "bridge/output/Figures.h"
#include "bridge/output/ResultsFolder.h"

namespace restenosis {
namespace {

namespace fs = std::filesystem;

struct TradeoffArguments {
  SceneArguments scene;
  std::string folder;
  std::vector<std::string> vary;
  int threads = 0;
  int ranks = 0;
};

bool solvesFlow(const Scene& scene) { return scene.flow && scene.flow->backend != flowBackendNames::none; }

/// What is swept: what the user asks for, or what suits the scene.
std::vector<SweptSetting> settingsFor(const Scene& scene, const std::vector<std::string>& vary) {
  if (vary.empty()) return sweptSettings(scene);
  std::vector<SweptSetting> settings;
  for (const std::string& text : vary) settings.push_back(readSweptSetting(text));
  return settings;
}

void nameTradeoffFiles(const fs::path& folder) {
  std::cout << fmt::format("\n{}:\n", folder.string());
  for (const auto& [file, what] :
       {std::pair("tradeoff.csv", "the same numbers"), std::pair("tradeoff.png", "picture")})
    if (fs::exists(folder / file)) std::cout << fmt::format("  {:<16} {}\n", file, what);
}

int sweep(const Scene& scene, const TradeoffArguments& arguments, const fs::path& folder,
          const std::vector<SweptSetting>& settings, const std::vector<std::vector<Scene>>& scenes) {
  const auto results = ResultsFolder::forOutput(folder);
  const TradeoffOptions options{
      .threads = threadCount(arguments.threads), .ranks = arguments.ranks, .stopRequested = &stopOnSignals()};
  omp_set_num_threads(options.threads);
  std::vector<TradeoffRow> rows;
  if (arguments.vary.empty() && solvesFlow(scene)) rows = flowTradeoff(arguments.scene, folder, options);
  const auto runs = runTradeoff(settings, scenes, folder / "runs", options);
  rows.insert(rows.end(), runs.begin(), runs.end());
  writeTradeoffCsv(folder / "tradeoff.csv", rows);
  if (scene.output.pictures) {
    const std::string obstacle = Figures().draw(folder, &stopOnSignals());
    if (!obstacle.empty()) std::cerr << obstacle << '\n';
  }
  std::cout << '\n' << tradeoffTable(rows);
  nameTradeoffFiles(folder);
  return ExitStatus::done;
}

int trySweep(const TradeoffArguments& arguments) {
  const auto scene = arguments.scene.read();
  if (!scene) return ExitStatus::wrongInput;
  std::vector<SweptSetting> settings;
  try {
    settings = settingsFor(*scene, arguments.vary);
  } catch (const std::invalid_argument& error) {
    std::cerr << error.what() << '\n';
    return ExitStatus::wrongInput;
  }
  if (settings.empty() && !solvesFlow(*scene)) {
    std::cerr << fmt::format("{}: it has neither tissue nor flow: there is nothing to trade\n",
                             arguments.scene.file);
    return ExitStatus::wrongInput;
  }
  const auto scenes = sweptScenes(arguments.scene, settings);
  if (!scenes) return ExitStatus::wrongInput;
  const fs::path folder = arguments.folder.empty() ? fs::path("results") / (scene->name + "-tradeoff")
                                                   : fs::path(arguments.folder);
  return exitStatusOf(
      [&] {
        // Refused before anything is written
        if (scene->hasLoadedLumen()) loadedLumen(*scene);
        return sweep(*scene, arguments, folder, settings, *scenes);
      },
      {.interrupted = [](const Interrupted& end) {
        return fmt::format("{}; the same command goes on with the runs", end.what());
      }});
}

}  // namespace

void addTradeoffCommand(CLI::App& app, int& status) {
  auto* command = app.add_subcommand(
      "tradeoff",
      "what accuracy costs: the flow at every fidelity, and runs with coarser and finer settings");
  auto arguments = std::make_shared<TradeoffArguments>();
  arguments->scene.addTo(*command);
  command
      ->add_option("-o,--output", arguments->folder,
                   "folder for the results (default: results/<scene name>-tradeoff)")
      ->check(aFolder());
  command
      ->add_option(
          "--vary", arguments->vary,
          "run the scene with each value of a key and nothing else: SECTION.KEY=VALUE,VALUE,..., the "
          "most accurate first, as in --vary \"coupling.lumenTolerance=1 um,5 um,20 um\"")
      ->allow_extra_args(false);
  command->add_option("--threads", arguments->threads, "OpenMP threads (default: all cores)")
      ->check(countUpTo(mostThreads));
  addRankOptions(*command, arguments->ranks);
  command->callback([arguments, &status] { status = trySweep(*arguments); });
}

}  // namespace restenosis

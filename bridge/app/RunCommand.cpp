#include "bridge/app/RunCommand.h"

#include <fmt/format.h>

#include <filesystem>
#include <iostream>
#include <memory>
#include <span>
#include <vector>

#include "bridge/app/ExitStatus.h"
#include "bridge/app/Failures.h"
#include "bridge/app/OptionChecks.h"
#include "bridge/app/RankOptions.h"
#include "bridge/app/SceneArguments.h"
#include "bridge/app/StopRequest.h"
#include "bridge/app/ThreadCount.h"
#include "bridge/coupling/FlowForecast.h"
#include "bridge/coupling/Plan.h"
#include "bridge/coupling/Run.h"
#include "bridge/coupling/RunHeader.h"
#include "bridge/output/Checkpoint.h"
#include "bridge/output/Figures.h"
#include "bridge/output/Progress.h"
#include "bridge/output/ResultsFolder.h"
#include "bridge/scene/SceneFiles.h"
#include "bridge/scene/SceneFingerprint.h"
#include "bridge/scene/SceneReader.h"
#include "bridge/scene/SceneWriter.h"
#include "bridge/scene/Units.h"
#include "bridge/system/AtomicFile.h"
#include "bridge/system/PrintableOutput.h"
#include "bridge/system/ShellCommand.h"

namespace restenosis {
namespace {

struct RunArguments {
  SceneArguments scene;
  std::string folder;
  int threads = 0;
  int ranks = 0;
  bool resume = false;
  bool flowFromRest = false;
  bool quiet = false, verbose = false;
  std::vector<std::string> commandLine;  ///< as the user gave it
};

void nameResults(const ResultsFolder& folder, const Run& run, bool pictures) {
  const auto& path = folder.path();
  std::cout << fmt::format("\n{} ({}):\n", path.string(), run.status());
  const auto name = [&](const char* file, const char* what) {
    if (std::filesystem::exists(path / file)) std::cout << fmt::format("  {:<16} {}\n", file, what);
  };
  name("summary.json", "final values, digest, cost by part");
  name("timeSeries.csv", "one row a recorded step");
  name("profile.csv", "final lumen along the vessel");
  name("thicknessMap.csv", "final neointima along and around the vessel");
  name("tissue.pvd", "agents in time: open in ParaView (Point Gaussian, scale by radius)");
  name("lumen.pvd", "lumen with wall shear stress in time: open in ParaView");
  name("struts.vtp", "closed surface of the struts: open in ParaView");
  if (std::filesystem::exists(path / "flow")) {
    for (const auto& entry : std::filesystem::directory_iterator(path / "flow")) {
      if (std::filesystem::exists(entry.path() / "case.foam"))
        std::cout << fmt::format("  {:<16} OpenFOAM case: open in ParaView\n",
                                 std::filesystem::relative(entry.path() / "case.foam", path).string());
    }
  }
  if (!pictures) return;
  for (const char* picture :
       {"vessel.png", "section.png", "growth.png", "lumen.png", "lumen3d.png", "beats.png"})
    name(picture, "picture");
  name("report.html", "all of it on one page: open in a browser");
  name("view.pvsm", "open in ParaView: the vessel cut open, day by day");
}

void printPoiseuille(const Run& run) {
  const auto error = run.poiseuille();
  if (!error) return;
  std::cout << fmt::format(
      "\nWSS against that of developed flow, {:.5g} Pa, without {:g} mm at either end: mean {:+.2f} %, L2 "
      "{:.2f} %, "
      "largest {:.2f} %\n",
      error->exact, 1e3 * error->endMargin, 100 * error->mean, 100 * error->l2, 100 * error->largest);
}

std::filesystem::path resultsPath(const Scene& scene, const RunArguments& arguments) {
  if (!arguments.folder.empty()) return arguments.folder;
  return std::filesystem::path("results") / scene.name;
}

/// What sets this scene apart from the one of the results at `path`, as far as it can be told.
std::string differencesFrom(const std::filesystem::path& path, const Scene& scene,
                            const CheckpointRefused& refused) {
  const auto inputs = sceneFiles(scene);
  std::string changed;
  for (const std::string& name : refused.changedInputs)
    changed += fmt::format("{}{} ({}) has been changed since the run was started",
                           changed.empty() ? "" : ", ", inputs.at(name).string(), name);
  try {
    const Units units;
    auto keys = lastingDifferences(SceneReader(units).readFile(path / "scene.toml", {}), scene);
    std::erase_if(keys, [&](const std::string& key) {
      return std::ranges::find(refused.changedInputs, key) != refused.changedInputs.end();
    });
    if (keys.empty() && !changed.empty()) return changed;
    if (keys.empty())
      return "the keys are the same: the two versions of the program do not have the same keys";
    std::string list;
    for (const std::string& key : keys) list.append(list.empty() ? "" : ", ").append(key);
    return fmt::format("{}{}they differ in {}", changed, changed.empty() ? "" : "; ", list);
  } catch (const std::exception&) {
    if (!changed.empty()) return changed;
    return fmt::format("{} cannot be compared with it", (path / "scene.toml").string());
  }
}

/// A new run would move them before it has read them. Throws FolderRefused.
void requireFilesElsewhere(const Scene& scene, const std::filesystem::path& folder) {
  for (const auto& [name, file] : sceneFiles(scene)) {
    if (!ResultsFolder::holdsAsResult(folder, file)) continue;
    throw FolderRefused(fmt::format(
        "{}, which the scene names, lies among the results in {}, which a new run moves aside: copy it to "
        "another place, or choose another folder with -o",
        file.string(), folder.string()));
  }
}

/// What is known before the run begins.
void sayWhatIsKnown(const Scene& scene, int ranks) {
  std::cerr << surfacesText(scene);
  if (scene.vessel.lumenSurface.empty())  // of a file the run says and records them
    for (const std::string& remark : scene.remarks) std::cerr << remark << '\n';
  for (const std::string& known : flowForecast(scene, ranks))
    std::cerr << fmt::format("The flow, once it is due, {}\n", known);
}

int runScene(const Scene& scene, const RunArguments& arguments) {
  const std::filesystem::path path = resultsPath(scene, arguments);
  if (!arguments.resume) requireFilesElsewhere(scene, path);
  const auto folder = arguments.resume ? ResultsFolder::resumed(path) : ResultsFolder::fresh(path);
  const int ranks = rankCount(scene, arguments.ranks);
  if (!arguments.quiet) sayWhatIsKnown(scene, ranks);
  std::ostream nowhere(nullptr);
  Progress progress(arguments.quiet ? nowhere : PrintableOutput::terminal(),
                    !arguments.quiet && Progress::onTerminal(), scene.scene.duration);
  if (arguments.verbose) progress.showEverything();
  const RunOptions options{.threads = threadCount(arguments.threads),
                           .ranks = ranks,
                           .stopRequested = &stopOnSignals(),
                           .flowFromRest = arguments.flowFromRest};
  Run run(scene, folder, progress, options);
  if (arguments.resume) run.resume();
  progress.message(runHeader(scene, {.threads = options.threads, .ranks = options.ranks, .results = path}));
  atomicWrite(folder.scene(), writeScene(scene, Units()));
  run.go();
  if (scene.output.pictures) {
    const std::string obstacle = Figures().draw(folder.path(), options.stopRequested);
    if (!obstacle.empty()) std::cerr << obstacle << '\n';
  }
  if (!arguments.quiet) {
    printPoiseuille(run);
    nameResults(folder, run, scene.output.pictures);
  }
  return ExitStatus::done;
}

/// Where an interrupted run stands, and how to go on.
std::string interruptedText(const Interrupted& end, const RunArguments& arguments) {
  std::vector<std::string> again = arguments.commandLine;
  if (!arguments.resume) again.emplace_back("--resume");
  const std::string command = shellCommand(again);
  if (end.saved.empty()) return fmt::format("interrupted, nothing saved yet: begin again with `{}`", command);
  return fmt::format("interrupted, saved at {}: go on with `{}`", end.saved, command);
}

int tryRun(const RunArguments& arguments) {
  const auto scene = arguments.scene.read();
  if (!scene) return ExitStatus::wrongInput;
  return exitStatusOf(
      [&] { return runScene(*scene, arguments); },
      {.interrupted = [&](const Interrupted& end) { return interruptedText(end, arguments); },
       .flowFailed = "Results so far are kept; go on with --resume, with another scene.fidelity or other "
                     "settings in [foam] or [lbm] if these are the cause.",
       .foreignCheckpoint =
           [&](const CheckpointRefused& refused) {
             return differencesFrom(resultsPath(*scene, arguments), *scene, refused);
           }});
}

}  // namespace

void addRunCommand(CLI::App& app, int& status, std::span<const char* const> commandLine) {
  auto* command = app.add_subcommand("run", "run a scene");
  auto arguments = std::make_shared<RunArguments>();
  arguments->commandLine.assign(commandLine.begin(), commandLine.end());
  arguments->scene.addTo(*command);
  arguments->scene.addFlowTo(*command);
  command
      ->add_option("-o,--output", arguments->folder, "folder for the results (default: results/<scene name>)")
      ->check(aFolder());
  command->add_option("--threads", arguments->threads, "OpenMP threads (default: all cores)")
      ->check(countUpTo(mostThreads));
  addRankOptions(*command, arguments->ranks);
  auto* resume =
      command->add_flag("--resume", arguments->resume, "go on from the checkpoint in the results folder");
  command
      ->add_flag("--flow-from-rest", arguments->flowFromRest,
                 "where the OpenFOAM case that the checkpoint goes on from is lost or changed, go on all the "
                 "same: the next flow is solved from rest on a new mesh, and the results say so")
      ->needs(resume);
  auto* quiet = command->add_flag("-q,--quiet", arguments->quiet, "say only what is wrong");
  command
      ->add_flag("-v,--verbose", arguments->verbose,
                 "show every step, and what the flow does, on lines of their own")
      ->excludes(quiet);
  command->callback([arguments, &status] { status = tryRun(*arguments); });
}

}  // namespace restenosis

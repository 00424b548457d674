#include "bridge/app/ComparedLumen.h"

#include <fmt/format.h>

#include <iostream>

#include "bridge/compare/LumenFile.h"
#include "bridge/coupling/Run.h"
#include "bridge/flow/LumenFrame.h"
#include "bridge/flow/LumenShape.h"
#include "bridge/output/Progress.h"
#include "bridge/scene/SceneWriter.h"
#include "bridge/scene/Units.h"
#include "bridge/surface/LoadedLumen.h"
#include "bridge/surface/SceneStent.h"
#include "bridge/surface/VesselAxis.h"
#include "bridge/system/AtomicFile.h"
#include "bridge/system/PrintableOutput.h"

namespace restenosis {

namespace {

/// The lumen of a day, laid where both backends solve in it. Throws LumenRefused where it is none.
ComparedLumen laidOfDay(const TriSurface& lumen, double day, const std::filesystem::path& file) {
  try {
    LaidLumen laid = laidLumen(lumen);
    const bool bent = !liesAlongZ(laid.surface);
    return {std::move(laid.surface), day, laid.frame, bent};
  } catch (const std::invalid_argument& error) {
    throw LumenRefused(fmt::format("{}: {}", file.string(), error.what()));
  }
}

}  // namespace

ComparedLumen deployedLumen(const Scene& scene, const std::filesystem::path& folder, int threads,
                            const std::atomic<bool>* stopRequested) {
  Scene deployment = scene;
  deployment.scene.duration = scene.scene.step;
  deployment.cellCycle.reset();
  deployment.contactInhibition.reset();
  deployment.endothelium.reset();
  deployment.flow.reset();
  deployment.output.pictures = false;
  const auto results = ResultsFolder::fresh(folder);
  // Of the whole scene, so that this folder can be compared again with other settings
  atomicWrite(results.scene(), writeScene(scene, Units()));
  Progress progress(PrintableOutput::terminal(), Progress::onTerminal(), deployment.scene.duration);
  Run run(deployment, results, progress, {.threads = threads, .stopRequested = stopRequested});
  run.go();
  progress.finish();
  const std::filesystem::path file = recordedLumens(folder).front().file;
  TriSurface lumen = readLumen(file);
  if (scene.vessel.isBent()) return laidOfDay(lumen, 0.0, file);
  return {std::move(lumen), 0.0};
}

ComparedLumen loadedLumen(const Scene& scene) {
  if (scene.outlets() == Outlets::several)
    throw LumenRefused(
        "the scene's 'outlets' in [flow] are solved by OpenFOAM alone: there is nothing to compare");
  return laidOfDay(loadLumen(scene.vessel), 0.0, scene.vessel.lumenSurface);
}

std::vector<Vec3> strutMiddles(const Scene& scene, const Eigen::Isometry3d& alongZ) {
  if (!scene.stent) return {};
  auto middles = makeStent(*scene.stent, scene.vessel).movedOutwards(scene.stent->deploymentDepth).middles();
  if (const auto axis = vesselAxis(scene.vessel))
    for (Vec3& middle : middles) middle = alongZ * axis->toBent(middle);
  return middles;
}

ComparedLumen finishedLumen(const std::filesystem::path& results, std::optional<double> day) {
  try {
    const auto lumens = recordedLumens(results);
    const RecordedLumen& chosen = day ? lumenOfDay(lumens, *day) : lumens.back();
    const TriSurface lumen = readLumen(chosen.file);
    if (liesAlongZ(lumen)) return {lumen, chosen.day};
    return laidOfDay(lumen, chosen.day, chosen.file);
  } catch (const LumenRefused&) {
    throw;
  } catch (const std::runtime_error& error) {
    throw LumenRefused(error.what());
  }
}

}  // namespace restenosis

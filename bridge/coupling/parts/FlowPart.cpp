#include "bridge/coupling/parts/FlowPart.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "bridge/coupling/FlowForecast.h"
#include "bridge/flow/LumenFrame.h"
#include "bridge/flow/PoiseuilleError.h"
#include "bridge/flow/backends/FlowBackends.h"
#include "bridge/scene/FlowResolution.h"
#include "bridge/scene/SceneFingerprint.h"
#include "bridge/scene/Units.h"
#include "bridge/surface/SurfaceCheck.h"
#include "tissue/parameters/SecondsPerDay.h"

namespace restenosis {

namespace {

/// Mean error of the stress in a plain tube, relative, from which on it is no solution (assumed).
constexpr double farFromPoiseuille = 0.5;

}  // namespace

std::unique_ptr<FlowPart> FlowPart::make(const PartContext& context) {
  const Scene& scene = context.world.scene;
  if (!scene.flow) return nullptr;
  auto backend = makeFlowBackend(scene.flow->backend, {.fidelity = scene.scene.fidelity,
                                                       .foam = scene.foam,
                                                       .lbm = scene.lbm,
                                                       .straightEnds = scene.flow->straightEnds,
                                                       .moveMesh = scene.coupling.remesh == "onDemand",
                                                       .ranks = context.ranks,
                                                       .stopRequested = context.stopRequested});
  if (!backend) return nullptr;
  if (scene.hasLoadedLumen()) backend = std::make_unique<AnyDirection>(std::move(backend));
  return std::make_unique<FlowPart>(context.world, std::move(backend));
}

FlowPart::FlowPart(World& world, std::unique_ptr<FlowBackend> backend)
    : world_(world), backend_(std::move(backend)), settings_(flowSettings(world.scene)) {}

Verdict FlowPart::inputsChanged(const Instant&) const {
  if (world_.flow.solves == 0 || settings_ != world_.flow.settings) return Verdict::run();
  if (world_.hasLoadedLumen()) return Verdict::skip("a loaded lumen does not change");
  const auto moved = displacement(world_.lumen.atLastFlow, world_.lumen.present);
  if (moved.robust > world_.scene.coupling.lumenTolerance) return Verdict::run();
  if (undecidedShareMoved() > world_.scene.coupling.undecidedShare) return Verdict::run();
  return Verdict::skip("lumen moved no more than lumenTolerance");
}

double FlowPart::undecidedShareMoved() const {
  const CouplingParameters& coupling = world_.scene.coupling;
  const AgentStore& agents = world_.wall.agents;
  const auto cells = world_.biology.rules().undecidedCells(agents, coupling.undecidedMargin);
  const auto moved = std::ranges::count_if(cells, [&](Index cell) {
    const Vec3 at = agents.position(cell);
    return std::abs(world_.lumen.present.radiusAt(at) - world_.lumen.atLastFlow.radiusAt(at)) >
           coupling.lumenTolerance;
  });
  return cells.empty() ? 0 : static_cast<double>(moved) / static_cast<double>(cells.size());
}

void FlowPart::run(const Instant& now) {
  if (world_.flow.solves == 0) requireResolution();
  const TriSurface& lumen = world_.lumenSurface();
  const std::filesystem::path folder = world_.folder.flowCase(now.time);
  if (!world_.hasLoadedLumen()) {
    auto measurement = world_.timer.measure("surface");
    const SurfaceReport report = checkSurface(lumen, world_.wall.length);
    if (!report.good())
      throw FlowFailed(fmt::format("the lumen surface cannot be meshed: {}", report.summary()), folder);
  }
  auto measurement = world_.timer.measure("flow");
  const FlowConditions conditions = world_.scene.flow->conditions(world_.scene.vessel.lumenDiameter);
  const bool asBefore = settings_ == world_.flow.settings;
  // What other settings have left is neither the mesh nor the flow that these would
  if (world_.flow.solves > 0 && asBefore && !world_.flow.fromRest)
    backend_->startFrom(world_.folder.flowCase(world_.flow.time));
  world_.flow.last = backend_->solve(lumen, conditions, folder);
  requirePoiseuille(conditions, folder);
  world_.timer.transfer("flow", "mesh", world_.flow.last->meshSeconds);
  if (world_.flow.solves > 0 && !asBefore) {
    remark(now, fmt::format("solved with other settings than before: {}",
                            settingsInPlace(world_.flow.settings, settings_)));
    world_.flow.mixed = true;
  }
  world_.flow.settings = settings_;
  for (const auto& text : world_.flow.last->remarks) remark(now, text);
  world_.flow.time = now.time;
  world_.flow.fromRest = false;
  noteStartFiles(folder);
  ++world_.flow.solves;
  if (world_.flow.last->meshMoved) ++world_.flow.meshesMoved;
  if (const auto& reason = world_.flow.last->remeshedBecause; !reason.empty())
    ++world_.flow.remeshedBecause[reason];
  world_.lumen.atLastFlow = world_.lumen.present;
  world_.changes.touch(Quantity::wallTraction);
  if (world_.scene.output.keepFlowCases == "last" && std::filesystem::exists(folder))
    world_.folder.removeFlowCasesBut(std::array{folder, world_.caseInCheckpoint});
}

FileDigests FlowPart::startFiles(const std::filesystem::path& formerCase) const {
  if (!backend_->needsFormerCase()) return {};
  return digestsOf(formerCase, backend_->filesToStartFrom(formerCase));
}

void FlowPart::noteStartFiles(const std::filesystem::path& folder) {
  try {
    world_.flow.startFiles = startFiles(folder);
  } catch (const std::runtime_error&) {
    world_.flow.startFiles.clear();  // the next solve says so when it comes to read them
  }
}

void FlowPart::requireResolution() const {
  if (world_.hasLoadedLumen()) return;  // looked at before the run
  if (const auto problem = resolutionProblem(world_.scene, Units())) throw FlowFailed(problem->message, {});
}

void FlowPart::requirePoiseuille(const FlowConditions& conditions,
                                 const std::filesystem::path& folder) const {
  const VesselParameters& vessel = world_.scene.vessel;
  if (!obeysPoiseuille(world_.scene)) return;
  const auto error = poiseuilleError(world_.flow.last->wall, vessel.lumenDiameter, vessel.length, conditions);
  if (!error || std::abs(error->mean) < farFromPoiseuille) return;
  throw FlowFailed(
      fmt::format("the wall shear stress in this plain tube is off Poiseuille's law, {:.3g} Pa, by "
                  "{:+.0f} % on the average: the solution is none",
                  error->exact, 100 * error->mean),
      folder);
}

void FlowPart::remark(const Instant& now, const std::string& text) {
  world_.flow.remarked.add(world_.remarks, fmt::format("flow at day {:.3f}: ", now.time / secondsPerDay),
                           text);
}

}  // namespace restenosis

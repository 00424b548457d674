#include "bridge/coupling/parts/FlowPart.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "bridge/coupling/FlowForecast.h"
#include "bridge/coupling/SceneFlow.h"
#include "bridge/flow/PoiseuilleError.h"
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
  RunState& run = context.run;
  const Scene& scene = run.scene;
  if (!scene.flow) return nullptr;
  auto backend = flowBackendFor(scene, scene.flow->backend, flowBackendOptions(context));
  if (!backend) return nullptr;
  return std::make_unique<FlowPart>(run.quantities, scene, run.folder, run.biology.rules(), run.extraction,
                                    run.remarks, run.timer, std::move(backend));
}

FlowPart::FlowPart(Quantities& quantities, const Scene& scene, const ResultsFolder& folder,
                   const ArrestRules& rules, LumenExtraction& extraction, std::vector<std::string>& remarks,
                   PartTimer& timer, std::unique_ptr<FlowBackend> backend)
    : Part(quantities),
      scene_(scene),
      folder_(folder),
      rules_(rules),
      extraction_(extraction),
      remarks_(remarks),
      timer_(timer),
      backend_(std::move(backend)),
      settings_(flowSettings(scene)) {}

Verdict FlowPart::inputsChanged(const Instant& now) const {
  if (flow_->solves == 0) return Verdict::run();
  if (!now.takesLumen) return Verdict::skip("lumenInterval is not over");
  if (settings_ != flow_->settings) return Verdict::run();
  if (scene_.hasLoadedLumen()) return Verdict::skip("a loaded lumen does not change");
  const auto moved = displacement(flow_->lumen, lumen_->present);
  if (moved.robust > scene_.coupling.lumenTolerance) return Verdict::run();
  if (undecidedShareMoved() > scene_.coupling.undecidedShare) return Verdict::run();
  return Verdict::skip("lumen moved no more than lumenTolerance");
}

double FlowPart::undecidedShareMoved() const {
  const AgentStore& agents = *stress_;
  const auto cells = rules_.undecidedCells(agents, scene_.coupling.undecidedMargin);
  const auto moved = std::ranges::count_if(cells, [&](Index cell) {
    const Vec3 at = agents.position(cell);
    return std::abs(lumen_->present.radiusAt(at) - flow_->lumen.radiusAt(at)) >
           scene_.coupling.lumenTolerance;
  });
  return cells.empty() ? 0 : static_cast<double>(moved) / static_cast<double>(cells.size());
}

void FlowPart::run(const Instant& now) {
  if (flow_->solves == 0) requireResolution();
  const TriSurface& lumen = extraction_.surface();
  const std::filesystem::path folder = folder_.flowCase(now.time);
  requireMeshable(lumen, folder);
  auto measurement = timer_.measure("flow");
  flow_.change([&](FlowState& flow) { solve(flow, lumen, now); });
  if (!scene_.output.keepsAllFlowCases() && std::filesystem::exists(folder))
    folder_.removeFlowCasesBut(std::array{folder, flow_->caseInCheckpoint});
}

void FlowPart::requireMeshable(const TriSurface& lumen, const std::filesystem::path& folder) const {
  if (scene_.hasLoadedLumen()) return;  // looked at before the run
  auto measurement = timer_.measure("surface");
  const SurfaceReport report = checkSurface(lumen, wall_->length);
  if (!report.good())
    throw FlowFailed(fmt::format("the lumen surface cannot be meshed: {}", report.summary()), folder);
}

void FlowPart::solve(FlowState& flow, const TriSurface& lumen, const Instant& now) {
  const std::filesystem::path folder = folder_.flowCase(now.time);
  FlowConditions conditions = scene_.flow->conditions(scene_.vessel.lumenDiameter);
  conditions.beating = scene_.flow->beating();
  conditions.outlets = scene_.flow->outletsOfTable();
  const bool asBefore = settings_ == flow.settings;
  // What other settings have left is neither the mesh nor the flow that these would
  if (flow.solves > 0 && asBefore && !flow.fromRest) backend_->startFrom(folder_.flowCase(flow.time));
  flow.last = backend_->solve(lumen, conditions, folder);
  requirePoiseuille(*flow.last, conditions, folder);
  timer_.transfer("flow", "mesh", flow.last->meshSeconds);
  if (flow.solves > 0 && !asBefore) {
    remark(
        flow, now,
        fmt::format("solved with other settings than before: {}", settingsInPlace(flow.settings, settings_)));
    flow.mixed = true;
  }
  flow.settings = settings_;
  for (const auto& text : flow.last->remarks) remark(flow, now, text);
  flow.time = now.time;
  flow.fromRest = false;
  flow.startFiles = startFilesOrNone(folder);
  ++flow.solves;
  if (flow.last->meshMoved) ++flow.meshesMoved;
  if (const auto& reason = flow.last->remeshedBecause; !reason.empty()) ++flow.remeshedBecause[reason];
  flow.lumen = lumen_->present;
}

FileDigests FlowPart::startFiles(const std::filesystem::path& formerCase) const {
  if (!backend_->needsFormerCase()) return {};
  return digestsOf(formerCase, backend_->filesToStartFrom(formerCase));
}

FileDigests FlowPart::startFilesOrNone(const std::filesystem::path& folder) const {
  try {
    return startFiles(folder);
  } catch (const std::runtime_error&) {
    return {};
  }
}

void FlowPart::requireResolution() const {
  if (scene_.hasLoadedLumen()) return;  // looked at before the run
  if (const auto problem = resolutionProblem(scene_, Units())) throw FlowFailed(problem->message, {});
}

void FlowPart::requirePoiseuille(const FlowSolution& solution, const FlowConditions& conditions,
                                 const std::filesystem::path& folder) const {
  const VesselParameters& vessel = scene_.vessel;
  if (!obeysPoiseuille(scene_)) return;
  const auto error = poiseuilleError(solution.wall, vessel.lumenDiameter, vessel.length, conditions);
  if (!error || std::abs(error->mean) < farFromPoiseuille) return;
  throw FlowFailed(
      fmt::format("the wall shear stress in this plain tube is off Poiseuille's law, {:.3g} Pa, by "
                  "{:+.0f} % on the average, so the solution is not used",
                  error->exact, 100 * error->mean),
      folder);
}

void FlowPart::remark(FlowState& flow, const Instant& now, const std::string& text) {
  flow.remarked.add(remarks_, fmt::format("flow at day {:.3f}: ", now.time / secondsPerDay), text);
}

}  // namespace restenosis

#include "bridge/coupling/Run.h"

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "bridge/coupling/FlowForecast.h"
#include "bridge/coupling/parts/CyclePart.h"
#include "bridge/coupling/parts/EndotheliumPart.h"
#include "bridge/coupling/parts/ExposurePart.h"
#include "bridge/coupling/parts/FlowPart.h"
#include "bridge/coupling/parts/LumenPart.h"
#include "bridge/coupling/parts/NitricOxidePart.h"
#include "bridge/coupling/parts/RelaxPart.h"
#include "bridge/coupling/parts/WallShearPart.h"
#include "bridge/flow/FlowBackendNames.h"
#include "bridge/flow/LumenFrame.h"
#include "bridge/flow/backends/FlowBackends.h"
#include "bridge/flow/foam/FoamTemplate.h"
#include "bridge/output/Build.h"
#include "bridge/output/ProfileCsv.h"
#include "bridge/output/SummaryJson.h"
#include "bridge/output/ThicknessMapCsv.h"
#include "bridge/scene/LoadedWall.h"
#include "bridge/scene/SceneFingerprint.h"
#include "bridge/surface/LumenSurface.h"
#include "bridge/surface/SceneStent.h"
#include "bridge/system/AtomicFile.h"
#include "tissue/agents/StateArchive.h"
#include "tissue/biology/StateCounts.h"
#include "tissue/forces/ForceField.h"
#include "tissue/parameters/SecondsPerDay.h"
#include "tissue/stent/Deployment.h"
#include "tissue/stent/EscapedAgents.h"
#include "tissue/stent/InjuryRemark.h"
#include "tissue/vessel/WallPacking.h"
#include "tissue/vessel/WallTable.h"

namespace restenosis {
namespace {

/// A checkpoint is saved at least this often, whatever the scene's interval: what a kill may cost.
constexpr std::chrono::seconds longestUnsaved{30};

// Of a number of intervals: less is rounding, which must not decide whether halfway has been reached.
constexpr double rounding = 1e-9;

/// Whether a multiple of the interval lies nearer to this step than to any other; halfway counts for the
/// first.
bool nextToMultiple(double time, double interval, double step) {
  if (interval <= step) return true;  // and the quotient may be beyond all numbers
  const auto multiplesUntil = [&](double t) { return std::floor(t / interval + rounding); };
  return multiplesUntil(time + step / 2) > multiplesUntil(time - step / 2);
}

/// Of this program, this machine and what the flow is solved with.
std::map<std::string, std::string> traitsOf(const Scene& scene) {
  auto traits = buildTraits();
  if (!scene.flow || scene.flow->backend != flowBackendNames::foam) return traits;
  try {
    const std::filesystem::path folder = foamTemplate();
    FileDigests files = digestsOf(folder, foamTemplateFiles(folder));
    HashingArchive hash;
    hash(files);
    traits["OpenFOAM case template"] = hash.digest();
  } catch (const std::runtime_error&) {
    // The solve says what is wrong with it
  }
  return traits;
}

}  // namespace

std::uint32_t stepCount(const SceneParameters& scene) {
  return static_cast<std::uint32_t>(std::lround(scene.duration / scene.step));
}

Run::Run(const Scene& scene, const ResultsFolder& folder, Progress& progress, const RunOptions& options)
    : scene_(scene),
      folder_(folder),
      options_(options),
      world_(scene, folder, progress),
      origin_{traitsOf(scene), inputDigests(scene)},
      checkpoint_(folder.checkpoint(), origin_),
      sceneFingerprint_(sceneFingerprint(scene)),
      checkpointFingerprint_(checkpointFingerprint(scene)),
      lastCheckpoint_(std::chrono::steady_clock::now()) {
  omp_set_num_threads(options.threads);
}

template <class Archive>
void Run::archive(Archive& a) {
  a(stage_, deploymentSteps_, nextStep_, world_);
  if (stage_ != Stage::growing) return;
  if (!schedule_) buildSchedule();
  a(*schedule_, *record_);
}

void Run::resume() {
  if (!checkpoint_.exists()) {
    // What was begun before the first checkpoint is begun again
    const bool moved = folder_.moveFormerRun(Unrecorded::deleted);
    world_.progress.message(
        fmt::format("no checkpoint: starting afresh{}", moved ? "; the former run is in previous/" : ""));
    return;
  }
  StoredState stored = checkpoint_.loadWithOrigin(checkpointFingerprint_);
  ReadingArchive state(std::move(stored.bytes));
  archive(state);
  if (nextStep_ > stepCount(scene_.scene)) {
    throw CheckpointRefused(
        CheckpointRefused::Reason::beyond,
        fmt::format("{} is of day {:.4g}, past scene.duration = {:.4g} d: ask for a longer duration, or for "
                    "another folder (-o)",
                    checkpoint_.file().string(), nextStep_ * scene_.scene.step / secondsPerDay,
                    scene_.scene.duration / secondsPerDay));
  }
  requireFormerCase();
  flushedSolve_ = world_.flow.solves;
  compareOrigin(stored.origin);
  folder_.removeFlowCasesAfter(world_.flow.solves > 0 ? std::optional(world_.flow.time) : std::nullopt);
  if (!lastFlowHasTheseSettings()) {
    world_.progress.message(fmt::format("the flow goes on with other settings than before: {}",
                                        settingsInPlace(world_.flow.settings, flowSettings(scene_))));
  }
  // It is of an end that is none any more
  std::filesystem::remove(folder_.summary());
  if (stage_ == Stage::growing) record_->begin();
}

bool Run::lastFlowHasTheseSettings() const {
  return world_.flow.solves == 0 || world_.flow.settings == flowSettings(scene_);
}

void Run::requireFormerCase() {
  noteCaseInCheckpoint();
  const std::string change = changeOfFormerCase();
  if (change.empty()) return;
  const auto& folder = world_.caseInCheckpoint;
  if (options_.flowFromRest) {
    world_.flow.fromRest = true;
    world_.flow.startFiles.clear();
    world_.reproducible = false;
    remark(
        fmt::format("the flow goes on from rest on a new mesh: resumed on day {:.4g} from the flow in {}, {}",
                    nextStep_ * scene_.scene.step / secondsPerDay, folder.string(), change));
    return;
  }
  using Reason = CheckpointRefused::Reason;
  throw CheckpointRefused(
      std::filesystem::is_directory(folder) ? Reason::caseChanged : Reason::caseMissing,
      fmt::format(
          "{} goes on from the flow in {}, {}: put it back as it was, or go on with --flow-from-rest, "
          "which solves the next flow from rest on a new mesh, and says so in the results",
          checkpoint_.file().string(), folder.string(), change));
}

std::string Run::changeOfFormerCase() const {
  const auto& folder = world_.caseInCheckpoint;
  const bool needed = !world_.flow.startFiles.empty() && lastFlowHasTheseSettings();
  if (!needed || !flowPart_) return {};
  if (!std::filesystem::is_directory(folder)) return "which is not there";
  try {
    return changeOfFiles(world_.flow.startFiles, flowPart_->startFiles(folder));
  } catch (const std::runtime_error& error) {
    return fmt::format("where {}", error.what());
  }
}

void Run::compareOrigin(const CheckpointOrigin& before) {
  const std::string others = traitsInPlace(before.traits, origin_.traits);
  if (others.empty()) return;
  world_.reproducible = false;
  remark(
      fmt::format("resumed on day {:.4g} by another program or machine, so that the state may differ from "
                  "that of a whole run: {}",
                  nextStep_ * scene_.scene.step / secondsPerDay, others));
}

void Run::noteCaseInCheckpoint() {
  if (world_.flow.solves > 0) world_.caseInCheckpoint = folder_.flowCase(world_.flow.time);
}

void Run::go() {
  try {
    if (stage_ == Stage::fresh) prepareWall();
    if (stage_ == Stage::deploying) deploy();
    grow();
    status_ = "finished";
  } catch (const Occluded&) {
    // A result, not a failure: the neointima has closed the vessel.
    status_ = "occluded";
    recordOcclusion();
  } catch (const Interrupted&) {
    endAs("interrupted");
    throw;
  } catch (const FlowFailed&) {
    // Programs that were asked to end may say that they failed
    const bool asked = isAskedToStop();
    endAs(asked ? "interrupted" : "failed");
    if (asked) throw Interrupted();
    throw;
  } catch (const std::exception&) {
    endAs("failed");
    throw;
  }
  writeFinalResults();
}

void Run::endAs(const char* status) {
  status_ = status;
  try {
    writeSummary();
  } catch (const WriteFailed&) {
    // What ended the run is told instead; it may be the full disk
  }
}

Wall Run::initialWall() {
  const VesselParameters& vessel = scene_.vessel;
  if (!vessel.agents.empty()) {
    std::optional<double> depth;
    if (scene_.stent) depth = scene_.stent->deploymentDepth;
    Wall wall = adoptWall(vessel, readWallTable(vessel, depth));
    // A packed wall's were set when it came to rest; injury may ask for them before this one does
    ForceField(*scene_.mechanics).setPressures(wall.agents, wall.bonds);
    return wall;
  }
  return packWall(vessel, vessel.lumenSurface.empty() ? cylindricalShape(vessel) : loadedWallShape(vessel),
                  *scene_.mechanics, *scene_.relaxation, static_cast<std::uint64_t>(scene_.scene.seed),
                  &world_.packing.emplace(), [this] {
                    if (isAskedToStop()) throw Interrupted();  // there is nothing to save yet
                  });
}

void Run::prepareWall() {
  if (!scene_.vessel.lumenSurface.empty())
    for (const std::string& text : scene_.remarks) remark(text);
  if (scene_.hasTissue()) {
    auto measurement = world_.timer.measure("pack");
    const std::string stage = scene_.vessel.agents.empty() ? "packing the wall" : "loading the wall";
    world_.progress.stage(stage, 0, 1);
    world_.wall = initialWall();
    world_.progress.stage(stage, 1, 1);
    if (!scene_.vessel.agents.empty()) remark(remarkOnOpenEnds(scene_.vessel, world_.wall.agents));
  }
  stage_ = Stage::deploying;
  saveCheckpoint();
}

void Run::deploy() {
  if (scene_.stent) {
    auto measurement = world_.timer.measure("deploy");
    deployStent();
    remarkOnLaw("after deployment");
  }
  startGrowth();
}

void Run::deployStent() {
  Deployment deployment(world_.wall, makeStent(*scene_.stent, scene_.vessel), *scene_.stent, scene_.vessel,
                        *scene_.mechanics, *scene_.relaxation, deploymentSteps_);
  while (!deployment.done()) {
    deployment.step();
    deploymentSteps_ = deployment.stepsDone();
    world_.progress.stage("deployment", deploymentSteps_, deployment.steps());
    stopIfAsked();
    checkpointWhenDue(false);
  }
  world_.wall.lastMove = std::vector<double>();
  world_.stent = deployment.stent();
  world_.deployment = deployment.statistics();
  remark(remarkOnEscaped(*world_.deployment, deployment.steps()));
  requireWallOutsideStruts(*world_.deployment, deployment.steps());
}

void Run::remarkOnLaw(const std::string& when) {
  constexpr std::string_view what =
      "agents are pressed deeper than the contact law holds for; its continuation acts on them";
  const auto tellsSo = [&](const std::string& text) { return text.find(what) != std::string::npos; };
  if (std::ranges::any_of(world_.remarks, tellsSo)) return;
  const Index pressed = ForceField(*scene_.mechanics).agentsBeyondLaw(world_.wall.agents);
  if (pressed > 0) remark(fmt::format("{} {} of {} {}", when, pressed, world_.wall.agents.size(), what));
}

void Run::remark(const std::string& text) {
  if (text.empty()) return;
  world_.remarks.push_back(text);
  world_.progress.message(text);
}

void Run::injureWall() {
  world_.injury = injure(world_.wall, *scene_.injury, static_cast<std::uint64_t>(scene_.scene.seed));
  remark(remarkOnInjury(*world_.injury, *scene_.injury));
}

void Run::startGrowth() {
  if (scene_.hasTissue()) {
    AgentStore& agents = world_.wall.agents;
    for (Index i = 0; i < agents.size(); ++i) {
      // The tissue outside is stiff: the EEL holds its place while cells grow (ISR3D).
      if (agents.kind[i] == AgentKind::eel) agents.set(i, fixed, true);
    }
    if (scene_.injury) injureWall();
    world_.confinement = OuterConfinement(agents, scene_.vessel.cellRadius);
    world_.changes.touch(Quantity::cellStates);
  }
  if (const std::string turbulent = turbulenceForecast(scene_); !turbulent.empty())
    world_.remarks.push_back(fmt::format("the flow {}", turbulent));
  buildSchedule();
  stage_ = Stage::growing;
  record_->begin();
}

void Run::buildSchedule() {
  const bool everyStep = scene_.coupling.schedule == "everyStep";
  schedule_ = std::make_unique<Schedule>(everyStep ? Schedule::Mode::everyStep : Schedule::Mode::onChange);
  // Not archived: where the stent stands after deployment follows from the scene.
  if (scene_.stent && !world_.stent)
    world_.stent = makeStent(*scene_.stent, scene_.vessel).movedOutwards(scene_.stent->deploymentDepth);
  auto backend =
      scene_.flow ? makeFlowBackend(scene_.flow->backend, {.fidelity = scene_.scene.fidelity,
                                                           .foam = scene_.foam,
                                                           .lbm = scene_.lbm,
                                                           .straightEnds = scene_.flow->straightEnds,
                                                           .moveMesh = scene_.coupling.remesh == "onDemand",
                                                           .ranks = options_.ranks,
                                                           .stopRequested = options_.stopRequested})
                  : nullptr;
  if (backend && world_.hasLoadedLumen()) backend = std::make_unique<AnyDirection>(std::move(backend));
  if (scene_.hasTissue()) schedule_->add(std::make_unique<RelaxPart>(world_));
  if (scene_.cellCycle) schedule_->add(std::make_unique<ExposurePart>(world_));
  if (scene_.endothelium) schedule_->add(std::make_unique<EndotheliumPart>(world_));
  schedule_->add(std::make_unique<LumenPart>(world_));
  if (backend) {
    auto flow = std::make_unique<FlowPart>(world_, std::move(backend));
    flowPart_ = flow.get();
    schedule_->add(std::move(flow));
    if (world_.biology.rules().readWss()) schedule_->add(std::make_unique<WallShearPart>(world_));
  }
  // Without flow there is none, but who is covered is part of the state all the same.
  if (scene_.endothelium) schedule_->add(std::make_unique<NitricOxidePart>(world_));
  auto record = std::make_unique<RecordPart>(world_);
  record_ = record.get();
  schedule_->add(std::move(record));
  if (scene_.cellCycle) schedule_->add(std::make_unique<CyclePart>(world_));
}

Instant Run::instant(std::uint32_t step) const {
  Instant now;
  now.step = step;
  now.time = step * scene_.scene.step;
  now.last = step == stepCount(scene_.scene);
  now.endsDay = nextToMultiple(now.time, secondsPerDay, scene_.scene.step);
  now.recorded = now.last || step == 0 || nextToMultiple(now.time, scene_.output.interval, scene_.scene.step);
  return now;
}

void Run::grow() {
  for (;; ++nextStep_) {
    const Instant now = instant(nextStep_);
    stopIfAsked();
    checkpointWhenDue(now.last ||
                      nextToMultiple(now.time, scene_.output.checkpointInterval, scene_.scene.step));
    schedule_->advance(now);
    // It takes as long as a step; tissue that rests does not come to such contacts between them
    if ((now.step == 0 || now.last) && scene_.hasTissue())
      remarkOnLaw(fmt::format("on day {:.4g}", now.time / secondsPerDay));
    reportProgress(now);
    if (now.last) break;
  }
}

void Run::recordOcclusion() {
  const Instant now = instant(nextStep_);
  record_->run(now);
  reportProgress(now);
  world_.progress.message(fmt::format("the lumen is closed on day {:.4g}", now.time / secondsPerDay));
}

bool Run::isAskedToStop() const { return options_.stopRequested && *options_.stopRequested; }

void Run::stopIfAsked() {
  if (!isAskedToStop()) return;
  saveCheckpoint();
  throw Interrupted();
}

void Run::checkpointWhenDue(bool regular) {
  if (regular || std::chrono::steady_clock::now() - lastCheckpoint_ > longestUnsaved) saveCheckpoint();
}

void Run::saveCheckpoint() {
  auto measurement = world_.timer.measure("output");
  flushFormerCase();
  checkpoint_.save(checkpointFingerprint_, [this](StreamingArchive& state) { archive(state); });
  lastCheckpoint_ = std::chrono::steady_clock::now();
  noteCaseInCheckpoint();
}

void Run::flushFormerCase() {
  if (world_.flow.startFiles.empty() || flushedSolve_ == world_.flow.solves) return;
  if (!lastFlowHasTheseSettings()) return;  // nothing starts from it
  flushFiles(folder_.flowCase(world_.flow.time), world_.flow.startFiles);
  flushedSolve_ = world_.flow.solves;
}

void Run::reportProgress(const Instant& now) {
  const StateCounts counts = countStates(world_.wall.agents);
  ProgressState state;
  state.time = now.time;
  state.agents = world_.wall.agents.size();
  state.g0 = counts.g0, state.g1 = counts.g1, state.sg2m = counts.sg2m;
  state.divisions = world_.divisions;
  state.flowSolves = world_.flow.solves;
  world_.progress.step(state, now.recorded);
}

std::string Run::stateDigest() {
  HashingArchive hash;
  hash(world_.wall.agents);
  return hash.digest();
}

std::optional<PoiseuilleError> Run::poiseuille() const {
  const VesselParameters& vessel = scene_.vessel;
  if (!world_.flow.last || !obeysPoiseuille(scene_)) return std::nullopt;
  return poiseuilleError(world_.flow.last->wall, vessel.lumenDiameter, vessel.length,
                         scene_.flow->conditions(vessel.lumenDiameter));
}

void Run::writeFinalResults() {
  world_.progress.finish();
  record_->end();
  const RadialMap& present = world_.lumen.present;
  std::vector<ProfileRow> rows(static_cast<std::size_t>(present.planes()));
  std::optional<Neointima> neointima;
  if (scene_.hasTissue() && present.comparable(world_.lumen.afterDeployment))
    neointima = measureNeointima(world_.lumen.afterDeployment, present, 0.0, world_.wall.length);
  for (int k = 0; k < present.planes(); ++k) {
    rows[k].z = present.z(k);
    rows[k].lumenArea = present.lumenArea(k);
    if (!neointima) continue;
    rows[k].neointimaAreaFraction = neointima->areaFraction[k];
    rows[k].neointimaThickness = neointima->thickness[k];
  }
  writeProfileCsv(folder_.profile(), rows);
  if (neointima) writeThicknessMapCsv(folder_.thicknessMap(), world_.lumen.afterDeployment, present);
  writeSummary();
}

void Run::writeSummary() {
  Summary summary;
  summary.scene = scene_.name;
  summary.title = scene_.scene.title;
  summary.status = status_;
  summary.seed = scene_.scene.seed;
  summary.threads = options_.threads;
  summary.ranks = options_.ranks;
  if (scene_.flow) summary.flowBackend = scene_.flow->backend;
  // The state is of no one scene once the flow has had other settings on the way, or of no one program
  if (world_.reproducible && !world_.flow.mixed && lastFlowHasTheseSettings())
    summary.sceneFingerprint = sceneFingerprint_;
  summary.stateDigest = stateDigest();
  if (record_ && !record_->timeSeries().rows().empty()) summary.last = record_->timeSeries().rows().back();
  summary.flowSolvesDone = world_.flow.solves;
  summary.flowMeshesMoved = world_.flow.meshesMoved;
  summary.flowRemeshed = world_.flow.remeshedBecause;
  if (schedule_) {
    const auto flow = schedule_->counts().find("flow");
    if (flow != schedule_->counts().end()) summary.flowSolvesSkipped = flow->second.skipped;
  }
  summary.packing = world_.packing;
  summary.deployment = world_.deployment;
  summary.injury = world_.injury;
  summary.relaxationIterations = world_.relaxation.iterations;
  summary.agentEvaluations = world_.relaxation.agentEvaluations;
  summary.relaxationResidual = world_.relaxation.residual;
  summary.poiseuille = poiseuille();
  summary.parts = world_.timer.costs();
  summary.remarks = world_.remarks;
  writeSummaryJson(folder_.summary(), summary);
}

}  // namespace restenosis

#include "bridge/coupling/Run.h"

#include <fmt/format.h>
#include <omp.h>

#include "bridge/coupling/FlowForecast.h"
#include "bridge/coupling/GrowthStep.h"
#include "bridge/scene/SceneFingerprint.h"
#include "bridge/surface/LumenSurface.h"
#include "bridge/surface/SceneStent.h"
#include "bridge/system/AtomicFile.h"
#include "tissue/agents/StateArchive.h"
#include "tissue/parameters/SecondsPerDay.h"

namespace restenosis {

Run::Run(const Scene& scene, const ResultsFolder& folder, Progress& progress, const RunOptions& options)
    : scene_(scene),
      folder_(folder),
      options_(options),
      state_(scene, folder, progress),
      preparation_(state_, options_),
      checkpoint_(state_),
      report_(state_, options_) {
  omp_set_num_threads(options.threads);
}

void Run::go() {
  try {
    if (stage_ == Stage::fresh) makeWall();
    if (stage_ == Stage::deploying) deploy();
    grow();
    status_ = "finished";
  } catch (const Occluded&) {
    // A result, not a failure: the neointima has closed the vessel.
    status_ = "occluded";
    recordOcclusion();
  } catch (const Interrupted&) {
    endAs("interrupted");
    throw Interrupted(saved_);
  } catch (const FlowFailed&) {
    // Programs that were asked to end may say that they failed
    const bool asked = options_.askedToStop();
    endAs(asked ? "interrupted" : "failed");
    if (asked) throw Interrupted(saved_);
    throw;
  } catch (const std::exception&) {
    endAs("failed");
    throw;
  }
  state_.progress.finish();
  record_->end();
  report_.writeFinalLumen();
  writeSummary();
}

void Run::makeWall() {
  if (!scene_.vessel.lumenSurface.empty())
    for (const std::string& text : scene_.remarks) state_.remark(text);
  if (scene_.hasTissue()) preparation_.makeWall();
  stage_ = Stage::deploying;
  save();
}

void Run::deploy() {
  if (scene_.stent) {
    preparation_.deploy(deploymentSteps_, [this] {
      stopIfAsked();
      if (checkpoint_.due()) save();
    });
  }
  if (scene_.hasTissue()) preparation_.injureAndConfine();
  startGrowth();
}

void Run::startGrowth() {
  if (const std::string turbulent = turbulenceForecast(scene_); !turbulent.empty())
    state_.remarks.push_back(fmt::format("the flow {}", turbulent));
  buildSchedule();
  stage_ = Stage::growing;
  record_->begin();
}

void Run::grow() {
  for (;; ++nextStep_) {
    const Instant now = instantOf(scene_, nextStep_);
    stopIfAsked();
    const bool regular =
        now.last || nextToMultiple(now.time, scene_.output.checkpointInterval, scene_.scene.step);
    if (regular || checkpoint_.due()) save();
    // growthStep: relax, expose, cover, take the lumen, solve the flow, ..., cycle
    schedule_->advance(now, [&] { beforeSolve(now); });
    // It takes as long as a step; tissue that rests does not come to such contacts between them
    if ((now.step == 0 || now.last) && scene_.hasTissue())
      remarkOnContactLaw(state_, fmt::format("on day {:.4g}", day()));
    report_.progress(now);
    if (now.last) break;
  }
}

void Run::buildSchedule() {
  schedule_ = std::make_unique<Schedule>(scene_.coupling.scheduleMode());
  // Not archived: where the stent stands after deployment follows from the scene.
  if (scene_.stent && !state_.stent)
    state_.stent = makeStent(*scene_.stent, scene_.vessel).movedOutwards(scene_.stent->deploymentDepth);
  const PartContext context{state_, options_.ranks, options_.stopRequested};
  for (const PartEntry& entry : growthStep()) {
    if (auto part = entry.make(context)) schedule_->add(std::move(part));
  }
  record_ = schedule_->find<RecordPart>();
  flow_ = schedule_->find<FlowPart>();
}

void Run::resume() {
  if (!checkpoint_.exists()) {
    // What was begun before the first checkpoint is begun again
    const bool moved = folder_.moveFormerRun(Unrecorded::deleted);
    state_.progress.message(
        fmt::format("no checkpoint: starting afresh{}", moved ? "; the former run is in previous/" : ""));
    return;
  }
  StoredState stored = checkpoint_.load();
  ReadingArchive state(std::move(stored.bytes));
  archive(state);
  if (nextStep_ > stepCount(scene_.scene)) {
    throw CheckpointRefused(
        CheckpointRefused::Reason::beyond,
        fmt::format("{} is of day {:.4g}, past scene.duration = {:.4g} d: ask for a longer duration, or for "
                    "another folder (-o)",
                    checkpoint_.file().string(), day(), scene_.scene.duration / secondsPerDay));
  }
  checkpoint_.adopt(stored.origin, flow_, day(), options_.flowFromRest);
  const FlowState& flow = state_.quantities.flow;
  folder_.removeFlowCasesAfter(flow.solves > 0 ? std::optional(flow.time) : std::nullopt);
  if (!state_.lastFlowHasTheseSettings()) {
    state_.progress.message(fmt::format("the flow goes on with other settings than before: {}",
                                        settingsInPlace(flow.settings, flowSettings(scene_))));
  }
  // It is of an end that is none any more
  std::filesystem::remove(folder_.summary());
  saved_ = place();
  state_.progress.message(fmt::format("resuming from {}", saved_));
  if (stage_ == Stage::growing) record_->begin();
}

template <class Archive>
void Run::archive(Archive& a) {
  a(stage_, deploymentSteps_, nextStep_, state_);
  if (stage_ != Stage::growing) return;
  if (!schedule_) buildSchedule();
  a(*schedule_);
  record_->archiveFiles(a);
}

void Run::save() {
  checkpoint_.save([this](StreamingArchive& state) { archive(state); });
  saved_ = place();
}

void Run::beforeSolve(const Instant& now) {
  // The last step has been saved at its start: with a longer duration, what runs before the flow may be less
  if (now.last) return;
  stopIfAsked();
  if (checkpoint_.dueBeforeSolve()) save();
}

void Run::stopIfAsked() {
  if (!options_.askedToStop()) return;
  save();
  throw Interrupted();
}

double Run::day() const { return nextStep_ * scene_.scene.step / secondsPerDay; }

std::string Run::place() const {
  if (stage_ == Stage::deploying && scene_.stent)
    return fmt::format("step {} of {} of deployment", deploymentSteps_, scene_.stent->deploymentSteps);
  return fmt::format("day {:.2f}", day());
}

void Run::recordOcclusion() {
  const Instant now = instantOf(scene_, nextStep_);
  record_->run(now);
  report_.progress(now);
  state_.progress.message(fmt::format("the lumen is closed on day {:.4g}", now.time / secondsPerDay));
}

void Run::endAs(const char* status) {
  status_ = status;
  try {
    writeSummary();
  } catch (const WriteFailed&) {
    // What ended the run is told instead; it may be the full disk
  }
}

void Run::writeSummary() const { report_.writeSummary(status_, schedule_.get(), record_); }

}  // namespace restenosis

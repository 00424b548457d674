#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include "bridge/coupling/Schedule.h"
#include "bridge/coupling/World.h"
#include "bridge/coupling/parts/FlowPart.h"
#include "bridge/coupling/parts/RecordPart.h"
#include "bridge/flow/PoiseuilleError.h"
#include "bridge/output/Checkpoint.h"
#include "bridge/output/ResultsFolder.h"

namespace restenosis {

/// The user asked the run to stop; its state is in the checkpoint.
struct Interrupted : std::runtime_error {
  Interrupted() : std::runtime_error("interrupted; go on with --resume") {}
};

/// What `Run::go` may be told beside the scene.
struct RunOptions {
  int threads = 1;
  int ranks = 1;  ///< processes of the flow solver
  const std::atomic<bool>* stopRequested =
      nullptr;  ///< set by a signal: save a checkpoint and throw Interrupted
  /// When resumed where the flow case that the next solve starts from is lost or changed: it starts from
  /// rest, on a new mesh, instead of being refused.
  bool flowFromRest = false;
};

/// A run from the packed wall to the end of growth: packs, deploys, injures, and then makes the coupled steps
/// of model 9. At every moment the checkpoint in the results folder holds a whole earlier state; a run gone
/// on from it with the same settings ends in the same state as one that never stopped.
class Run {
 public:
  Run(const Scene& scene, const ResultsFolder& folder, Progress& progress, const RunOptions& options);

  /// Reads the state from the checkpoint instead of starting afresh; without one, the run starts afresh.
  /// Throws CheckpointRefused for one that is damaged, of another scene or of a time past the scene's end.
  void resume();
  /// Goes on to the end and writes the final results. Throws RelaxationFailed, FlowFailed, WriteFailed,
  /// Interrupted; what has been recorded so far stays.
  void go();

  std::string status() const { return status_; }
  std::string stateDigest();
  /// The error of the last flow against Poiseuille's law, where it holds: in a straight tube without tissue,
  /// at a fixed flow rate.
  std::optional<PoiseuilleError> poiseuille() const;

 private:
  enum class Stage : std::uint8_t { fresh, deploying, growing };

  /// The wall that the scene describes, at rest.
  Wall initialWall();
  void prepareWall();
  void deploy();
  void deployStent();
  /// Adds a remark, if there is one, and says it.
  void remark(const std::string& text);
  /// Says, once, that the contact law's continuation acts on agents.
  void remarkOnLaw(const std::string& when);
  void injureWall();
  void startGrowth();
  void buildSchedule();
  void grow();
  Instant instant(std::uint32_t step) const;
  void checkpointWhenDue(bool regular);
  void saveCheckpoint();
  /// True before the first flow.
  bool lastFlowHasTheseSettings() const;
  /// Throws CheckpointRefused where the next solve needs the case of the last one and it is gone or changed.
  void requireFormerCase();
  /// How that case has changed, as the end of a sentence that begins with its folder; empty where it has not.
  std::string changeOfFormerCase() const;
  /// What the next solve reads is on the disk before a checkpoint names it.
  void flushFormerCase();
  /// Remarks on a state that another version, compiler or processor has saved.
  void compareOrigin(const CheckpointOrigin& before);
  void noteCaseInCheckpoint();
  bool isAskedToStop() const;
  void stopIfAsked();
  void recordOcclusion();
  void reportProgress(const Instant& now);
  void writeFinalResults();
  void writeSummary();
  /// Says in summary.json how a run came to its end before its time.
  void endAs(const char* status);
  template <class Archive>
  void archive(Archive& a);

  const Scene& scene_;
  const ResultsFolder& folder_;
  RunOptions options_;
  World world_;
  CheckpointOrigin origin_;
  Checkpoint checkpoint_;
  std::string sceneFingerprint_, checkpointFingerprint_;  ///< of when the run was started or resumed
  std::unique_ptr<Schedule> schedule_;
  RecordPart* record_ = nullptr;    ///< owned by the schedule
  FlowPart* flowPart_ = nullptr;    ///< owned by the schedule; null for none
  std::uint64_t flushedSolve_ = 0;  ///< number of the solve whose case is known to be on the disk

  Stage stage_ = Stage::fresh;
  std::int32_t deploymentSteps_ = 0;  ///< done
  std::uint32_t nextStep_ = 0;
  std::string status_ = "running";
  std::chrono::steady_clock::time_point lastCheckpoint_;
};

/// Number of biological steps of a scene.
std::uint32_t stepCount(const SceneParameters& scene);

}  // namespace restenosis

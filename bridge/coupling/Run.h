#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "bridge/coupling/Instant.h"
#include "bridge/coupling/RunCheckpoint.h"
#include "bridge/coupling/RunOptions.h"
#include "bridge/coupling/RunReport.h"
#include "bridge/coupling/RunState.h"
#include "bridge/coupling/Schedule.h"
#include "bridge/coupling/WallPreparation.h"
#include "bridge/coupling/parts/FlowPart.h"
#include "bridge/coupling/parts/RecordPart.h"

namespace restenosis {

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
  std::string stateDigest() const { return report_.stateDigest(); }
  /// The error of the last flow against Poiseuille's law, where it holds: in a straight tube without tissue,
  /// at a fixed flow rate.
  std::optional<PoiseuilleError> poiseuille() const { return report_.poiseuille(); }

 private:
  enum class Stage : std::uint8_t { fresh, deploying, growing };

  void makeWall();
  void deploy();
  void startGrowth();
  void grow();
  void buildSchedule();

  void save();
  void beforeSolve(const Instant& now);
  void stopIfAsked();
  double day() const;
  /// Where the state stands, for messages: "day 3.00".
  std::string place() const;
  /// Records the state in which the lumen has closed.
  void recordOcclusion();
  /// Says in summary.json how a run came to its end before its time.
  void endAs(const char* status);
  void writeSummary() const;
  template <class Archive>
  void archive(Archive& a);

  const Scene& scene_;
  const ResultsFolder& folder_;
  RunOptions options_;
  RunState state_;
  WallPreparation preparation_;
  RunCheckpoint checkpoint_;
  RunReport report_;
  std::unique_ptr<Schedule> schedule_;  ///< of growth
  RecordPart* record_ = nullptr;        ///< owned by the schedule
  FlowPart* flow_ = nullptr;            ///< owned by the schedule; null for none

  Stage stage_ = Stage::fresh;
  std::int32_t deploymentSteps_ = 0;  ///< done
  std::uint32_t nextStep_ = 0;
  std::string status_ = "running";
  std::string saved_;  ///< place of the state in the checkpoint; empty for none
};

}  // namespace restenosis

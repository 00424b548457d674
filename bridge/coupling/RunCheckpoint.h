#pragma once

#include <chrono>
#include <filesystem>
#include <string>

#include "bridge/coupling/FormerFlowCase.h"
#include "bridge/coupling/RunState.h"
#include "bridge/output/Checkpoint.h"

namespace restenosis {

/// When a run's state is saved, and whether a saved one may be gone on from.
class RunCheckpoint {
 public:
  explicit RunCheckpoint(RunState& state);

  bool exists() const { return checkpoint_.exists(); }
  std::filesystem::path file() const { return checkpoint_.file(); }
  /// Throws CheckpointRefused for a state that is damaged or of another scene.
  StoredState load() const { return checkpoint_.loadWithOrigin(fingerprint_); }
  /// The state has been read: refuses it without the files it goes on from (FormerFlowCase), and remarks on
  /// one that another version, compiler or processor has saved. `day`: of the state.
  void adopt(const CheckpointOrigin& savedBy, const FlowPart* flow, double day, bool flowFromRest);

  /// Throws WriteFailed.
  void save(const Checkpoint::StateWriter& state);
  /// Whether a kill would cost too much.
  bool due() const;
  /// The same before a flow is solved: before the first, whose cost nobody knows, and before others where
  /// savings take no more than a share of the run, however cheap the flow.
  bool dueBeforeSolve() const;

 private:
  void compareOrigin(const CheckpointOrigin& before, double day);

  RunState& state_;
  CheckpointOrigin origin_;
  Checkpoint checkpoint_;
  std::string fingerprint_;  ///< of when the run was started or resumed
  FormerFlowCase formerCase_;
  std::chrono::steady_clock::time_point lastSaved_ = std::chrono::steady_clock::now();
  std::chrono::steady_clock::duration saving_{};  ///< what saving took the last time
};

}  // namespace restenosis

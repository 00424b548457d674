#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bridge/coupling/Instant.h"
#include "bridge/coupling/RunOptions.h"
#include "bridge/coupling/RunState.h"
#include "bridge/coupling/Schedule.h"
#include "bridge/coupling/parts/RecordPart.h"
#include "bridge/flow/PoiseuilleError.h"
#include "bridge/output/PlannedPart.h"
#include "bridge/output/Provenance.h"

namespace restenosis {

/// What a run tells of itself: progress, and the files that are written at its end.
class RunReport {
 public:
  RunReport(RunState& state, const RunOptions& options);

  void progress(const Instant& now) const;
  /// Hash over all agents.
  std::string stateDigest() const;
  /// Run::poiseuille.
  std::optional<PoiseuilleError> poiseuille() const;

  /// profile.csv and thicknessMap.csv. Throws WriteFailed.
  void writeFinalLumen() const;
  /// summary.json; `schedule` and `record` are null before growth. Throws WriteFailed.
  void writeSummary(const std::string& status, const Schedule* schedule, const RecordPart* record) const;

 private:
  RunState& state_;
  Quantities& quantities_;
  const RunOptions& options_;
  // Of when the run was started or resumed: files that the scene names may have changed since
  std::string sceneFingerprint_;
  std::vector<PlannedPart> plan_;
  Provenance provenance_ = Provenance::ofThisProcess();
};

}  // namespace restenosis

#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "bridge/coupling/RunState.h"
#include "bridge/coupling/parts/FlowPart.h"

namespace restenosis {

/// The case of the last solve, where the next one starts from it (FlowBackend::filesToStartFrom): part of the
/// state, beside what the checkpoint's own file holds.
class FormerFlowCase {
 public:
  explicit FormerFlowCase(RunState& state) : state_(state), flow_(state.quantities.flow) {}

  /// The state has been read from a checkpoint. Throws CheckpointRefused, which begins with `checkpoint`,
  /// where the next solve of `part` (null for none) needs the case and it is gone or changed; with `fromRest`
  /// remarks on it, and the next solve starts from rest.
  void requireAfterResume(const FlowPart* part, const std::string& checkpoint, double day, bool fromRest);
  /// Before a checkpoint names it: what the next solve reads is on the disk.
  void flush();
  /// A checkpoint knows the present case.
  void noteInCheckpoint();

 private:
  /// How it has changed, as the end of a sentence that begins with its folder; empty where it has not.
  std::string change(const FlowPart* part) const;

  RunState& state_;
  FlowState& flow_;
  std::uint64_t flushedSolve_ = 0;  ///< number of the solve whose case is known to be on the disk
};

}  // namespace restenosis

#include "bridge/coupling/FormerFlowCase.h"

#include <fmt/format.h>

#include <stdexcept>

#include "bridge/output/Checkpoint.h"

namespace restenosis {

void FormerFlowCase::requireAfterResume(const FlowPart* part, const std::string& checkpoint, double day,
                                        bool fromRest) {
  noteInCheckpoint();
  flushedSolve_ = flow_.solves;
  const std::string changed = change(part);
  if (changed.empty()) return;
  const auto& folder = flow_.caseInCheckpoint;
  if (fromRest) {
    flow_.fromRest = true;
    flow_.startFiles.clear();
    state_.reproducible = false;
    state_.remark(
        fmt::format("the flow goes on from rest on a new mesh: resumed on day {:.4g} from the flow in {}, {}",
                    day, folder.string(), changed));
    return;
  }
  using Reason = CheckpointRefused::Reason;
  throw CheckpointRefused(
      std::filesystem::is_directory(folder) ? Reason::caseChanged : Reason::caseMissing,
      fmt::format(
          "{} goes on from the flow in {}, {}: put it back as it was, or go on with --flow-from-rest, "
          "which solves the next flow from rest on a new mesh, and says so in the results",
          checkpoint, folder.string(), changed));
}

std::string FormerFlowCase::change(const FlowPart* part) const {
  const auto& folder = flow_.caseInCheckpoint;
  const bool needed = !flow_.startFiles.empty() && state_.lastFlowHasTheseSettings();
  if (!needed || !part) return {};
  if (!std::filesystem::is_directory(folder)) return "which is not there";
  try {
    return changeOfFiles(flow_.startFiles, part->startFiles(folder));
  } catch (const std::runtime_error& error) {
    return fmt::format("where {}", error.what());
  }
}

void FormerFlowCase::flush() {
  if (flow_.startFiles.empty() || flushedSolve_ == flow_.solves) return;
  if (!state_.lastFlowHasTheseSettings()) return;  // nothing starts from it
  flushFiles(state_.folder.flowCase(flow_.time), flow_.startFiles);
  flushedSolve_ = flow_.solves;
}

void FormerFlowCase::noteInCheckpoint() {
  if (flow_.solves > 0) flow_.caseInCheckpoint = state_.folder.flowCase(flow_.time);
}

}  // namespace restenosis

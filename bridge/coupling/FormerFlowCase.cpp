#include "bridge/coupling/FormerFlowCase.h"

#include <fmt/format.h>

#include <stdexcept>

#include "bridge/output/Checkpoint.h"

namespace restenosis {

void FormerFlowCase::requireAfterResume(const FlowPart* flow, const std::string& checkpoint, double day,
                                        bool fromRest) {
  noteInCheckpoint();
  flushedSolve_ = world_.flow.solves;
  const std::string changed = change(flow);
  if (changed.empty()) return;
  const auto& folder = world_.caseInCheckpoint;
  if (fromRest) {
    world_.flow.fromRest = true;
    world_.flow.startFiles.clear();
    world_.reproducible = false;
    world_.remark(
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

std::string FormerFlowCase::change(const FlowPart* flow) const {
  const auto& folder = world_.caseInCheckpoint;
  const bool needed = !world_.flow.startFiles.empty() && world_.lastFlowHasTheseSettings();
  if (!needed || !flow) return {};
  if (!std::filesystem::is_directory(folder)) return "which is not there";
  try {
    return changeOfFiles(world_.flow.startFiles, flow->startFiles(folder));
  } catch (const std::runtime_error& error) {
    return fmt::format("where {}", error.what());
  }
}

void FormerFlowCase::flush() {
  if (world_.flow.startFiles.empty() || flushedSolve_ == world_.flow.solves) return;
  if (!world_.lastFlowHasTheseSettings()) return;  // nothing starts from it
  flushFiles(world_.folder.flowCase(world_.flow.time), world_.flow.startFiles);
  flushedSolve_ = world_.flow.solves;
}

void FormerFlowCase::noteInCheckpoint() {
  if (world_.flow.solves > 0) world_.caseInCheckpoint = world_.folder.flowCase(world_.flow.time);
}

}  // namespace restenosis

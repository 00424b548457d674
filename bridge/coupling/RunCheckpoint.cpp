#include "bridge/coupling/RunCheckpoint.h"

#include <fmt/format.h>

#include <map>
#include <stdexcept>

#include "bridge/flow/FlowBackendNames.h"
#include "bridge/flow/foam/FoamTemplate.h"
#include "bridge/output/Build.h"
#include "bridge/scene/SceneFingerprint.h"
#include "tissue/agents/StateArchive.h"

namespace restenosis {
namespace {

/// A checkpoint is saved at least this often, whatever the scene's interval: what a kill may cost.
constexpr std::chrono::seconds longestUnsaved{30};

/// Before a solve it is saved when the work since then has taken this many times as long as saving does.
constexpr int workPerSaving = 20;

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

RunCheckpoint::RunCheckpoint(RunState& state)
    : state_(state),
      origin_{traitsOf(state.scene), inputDigests(state.scene)},
      checkpoint_(state.folder.checkpoint(), origin_),
      fingerprint_(checkpointFingerprint(state.scene)),
      formerCase_(state) {}

void RunCheckpoint::adopt(const CheckpointOrigin& savedBy, const FlowPart* flow, double day,
                          bool flowFromRest) {
  formerCase_.requireAfterResume(flow, file().string(), day, flowFromRest);
  compareOrigin(savedBy, day);
}

void RunCheckpoint::compareOrigin(const CheckpointOrigin& before, double day) {
  const std::string others = traitsInPlace(before.traits, origin_.traits);
  if (others.empty()) return;
  state_.reproducible = false;
  state_.remark(
      fmt::format("resumed on day {:.4g} by another program or machine, so that the state may differ from "
                  "that of a whole run: {}",
                  day, others));
}

void RunCheckpoint::save(const Checkpoint::StateWriter& state) {
  auto measurement = state_.timer.measure("output");
  const auto begin = std::chrono::steady_clock::now();
  formerCase_.flush();
  checkpoint_.save(fingerprint_, state);
  lastSaved_ = std::chrono::steady_clock::now();
  saving_ = lastSaved_ - begin;
  formerCase_.noteInCheckpoint();
}

bool RunCheckpoint::due() const { return std::chrono::steady_clock::now() - lastSaved_ > longestUnsaved; }

bool RunCheckpoint::dueBeforeSolve() const {
  return state_.quantities.flow.solves == 0 ||
         std::chrono::steady_clock::now() - lastSaved_ > workPerSaving * saving_;
}

}  // namespace restenosis

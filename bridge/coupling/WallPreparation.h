#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "bridge/coupling/RunOptions.h"
#include "bridge/coupling/RunState.h"
#include "bridge/output/PlannedPart.h"

namespace restenosis {

/// Makes the wall that growth starts from: packed or loaded, the stent deployed, injured (model 2 to 4).
class WallPreparation {
 public:
  static std::vector<PlannedPart> explain(const Scene& scene);

  WallPreparation(RunState& state, const RunOptions& options)
      : state_(state), wall_(state.quantities.wall), options_(options) {}

  /// The wall that the scene describes, at rest. Throws Interrupted while it is packed: there is nothing to
  /// save yet.
  void makeWall();
  /// Deploys the stent, from the step that `stepsDone` says; calls `afterStep` after each. Throws
  /// RelaxationFailed.
  void deploy(std::int32_t& stepsDone, const std::function<void()>& afterStep);
  /// Fixes the EEL, injures, and confines what grows from now on.
  void injureAndConfine();

 private:
  Wall initialWall();
  void notePackedPlaces();

  RunState& state_;
  Wall& wall_;
  const RunOptions& options_;
};

/// Remarks, once a run, that the contact law's continuation acts on agents.
void remarkOnContactLaw(RunState& state, const std::string& when);

}  // namespace restenosis

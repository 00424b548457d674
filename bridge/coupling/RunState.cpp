#include "bridge/coupling/RunState.h"

#include "bridge/scene/SceneBiology.h"
#include "bridge/scene/SceneFingerprint.h"

namespace restenosis {

RunState::RunState(const Scene& s, const ResultsFolder& f, Progress& p)
    : scene(s),
      folder(f),
      progress(p),
      quantities(emptyWall(s.vessel)),
      axis(vesselAxis(s.vessel)),
      extraction(scene, quantities.wall, stent, timer),
      biology(biologySettings(s)) {
  biology.model(quantities.wall.agents);
}

void RunState::remark(const std::string& text) {
  if (text.empty()) return;
  remarks.push_back(text);
  progress.message(text);
}

bool RunState::lastFlowHasTheseSettings() const { return quantities.flow.hasSettings(flowSettings(scene)); }

}  // namespace restenosis

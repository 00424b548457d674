#pragma once

#include <vector>

#include "bridge/scene/SceneCheck.h"

namespace restenosis {

/// Rules of [flow]: what drives it, what flows, where it leaves, and which backend can solve it.
const std::vector<SceneCheck>& flowChecks();

}  // namespace restenosis

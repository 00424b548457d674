#pragma once

#include <vector>

#include "bridge/scene/SceneCheck.h"

namespace restenosis {

/// Rules of the shape of the lumen and its axis: what says it, and how sharply it may bend.
const std::vector<SceneCheck>& axisChecks();

}  // namespace restenosis

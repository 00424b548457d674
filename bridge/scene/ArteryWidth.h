#pragma once

#include <string>

#include "bridge/scene/Scene.h"

namespace restenosis {

/// That a lumen [m] is not as wide as coronary arteries are, which a mistaken unit may have made; in which
/// unit of its file, if it has one, it would be. Empty where there is nothing to say.
std::string remarkOnWidth(const Scene& scene, double diameter);

}  // namespace restenosis

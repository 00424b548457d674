#pragma once

#include <string>

#include "bridge/scene/Scene.h"
#include "bridge/scene/Units.h"

namespace restenosis {

/// The resolved scene as TOML: the sections that are modelled, every key with its default written out, each
/// with what it means and where its default comes from. Reading it back gives the same parameters to the last
/// bit.
std::string writeScene(const Scene& scene, const Units& units);

}  // namespace restenosis

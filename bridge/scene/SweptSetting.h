#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "bridge/scene/Scene.h"

namespace restenosis {

/// A key of the scene and the values it is run with, as they are written behind `--set`; the first is what
/// the others are measured against.
struct SweptSetting {
  std::string key;
  std::vector<std::string> values;
};

/// Reads "section.key=value,value,...". Throws std::invalid_argument where it is none, or names fewer than
/// two values.
SweptSetting readSweptSetting(std::string_view text);

/// What a run of this scene trades speed for accuracy by, around the scene's own values and the most accurate
/// first, and the seeds: what chance alone does.
std::vector<SweptSetting> sweptSettings(const Scene& scene);

}  // namespace restenosis

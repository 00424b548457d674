#pragma once

#include <string>
#include <vector>

#include "bridge/scene/Scene.h"
#include "bridge/scene/Units.h"

namespace restenosis {

/// A key of a scene whose value is not the default; values as authors write them.
struct DefaultDifference {
  std::string key;  ///< "section.key"
  std::string value;
  std::string byDefault;  ///< empty where the key has no default
  std::string meaning;
};

/// What the modelled sections of a scene have that their defaults have not, in the order of the scene;
/// required keys always.
std::vector<DefaultDifference> defaultDifferences(const Scene& scene, const Units& units);

}  // namespace restenosis

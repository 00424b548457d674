#pragma once

#include <fmt/format.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bridge/scene/Scene.h"
#include "bridge/scene/Units.h"

namespace restenosis {

/// What a rule has found wrong, in words.
using Finding = std::optional<std::string>;

/// One rule. `reads` are the keys it looks at, "section" or "section.key"; the first is the one to blame.
struct SceneCheck {
  std::vector<std::string_view> reads;
  Finding (*find)(const Scene& scene, const Units& units);
};

/// A length or time for people: no digits beyond what anyone types.
inline std::string shownIn(const Units& units, double si, const std::string& unit) {
  return fmt::format("{:.6g} {}", units.fromSi(si, unit), unit);
}

}  // namespace restenosis

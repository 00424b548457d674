#include "bridge/scene/SweptSetting.h"

#include <fmt/format.h>

#include <stdexcept>

#include "bridge/scene/SceneBiology.h"
#include "tissue/parameters/Trimmed.h"

namespace restenosis {
namespace {

/// Times the scene's own value, the most accurate first.
constexpr double factors[] = {0.25, 0.5, 1, 2, 4};

}  // namespace

SweptSetting readSweptSetting(std::string_view text) {
  const auto equals = text.find('=');
  SweptSetting swept;
  swept.key = trimmed(text.substr(0, equals));
  if (equals != std::string_view::npos) {
    std::string_view rest = text.substr(equals + 1);
    for (;;) {
      const auto comma = rest.find(',');
      swept.values.emplace_back(trimmed(rest.substr(0, comma)));
      if (comma == std::string_view::npos) break;
      rest.remove_prefix(comma + 1);
    }
  }
  bool whole = swept.key.find('.') != std::string::npos && swept.values.size() > 1;
  for (const std::string& value : swept.values) whole = whole && !value.empty();
  if (!whole)
    throw std::invalid_argument(fmt::format(
        "--vary {}: write section.key=value,value with two values or more, the most accurate first", text));
  return swept;
}

std::vector<SweptSetting> sweptSettings(const Scene& scene) {
  std::vector<SweptSetting> all;
  if (!scene.hasTissue()) return all;
  SweptSetting tolerance{"relaxation.tolerance", {}};
  for (const double factor : factors)
    tolerance.values.push_back(fmt::format("{:.6g}", factor * scene.relaxation->tolerance));
  all.push_back(tolerance);
  if (growthReadsFlow(scene) && scene.coupling.scheduleMode() == ScheduleMode::onChange) {
    SweptSetting lumen{"coupling.lumenTolerance", {}};
    for (const double factor : factors)
      lumen.values.push_back(fmt::format("{:.6g} um", 1e6 * factor * scene.coupling.lumenTolerance));
    all.push_back(lumen);
  }
  SweptSetting seed{"scene.seed", {}};
  for (const int further : {0, 1, 2}) seed.values.push_back(fmt::format("{}", scene.scene.seed + further));
  all.push_back(seed);
  return all;
}

}  // namespace restenosis

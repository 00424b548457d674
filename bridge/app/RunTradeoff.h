#pragma once

#include <filesystem>
#include <vector>

#include "bridge/app/FlowTradeoff.h"
#include "bridge/app/SceneArguments.h"
#include "bridge/output/TradeoffRows.h"
#include "bridge/scene/SweptSetting.h"

namespace restenosis {

/// The scenes that a sweep runs, one for each value of each setting, all valid. Prints what is wrong with a
/// value and returns nothing.
std::optional<std::vector<std::vector<Scene>>> sweptScenes(const SceneArguments& scene,
                                                           const std::vector<SweptSetting>& settings);

/// Runs the scene with each value of each setting, into folders of its own below `folder`: seconds of the
/// whole run, and how far the neointima's thickness at the end (without one, the smallest lumen area) is from
/// that with the setting's first value. A run that another value has made already, or that a former sweep has
/// finished there, is not made again, and one that was interrupted goes on. A run whose
/// tissue or flow fails is named and left out. Throws what Run throws beside that.
std::vector<TradeoffRow> runTradeoff(const std::vector<SweptSetting>& settings,
                                     const std::vector<std::vector<Scene>>& scenes,
                                     const std::filesystem::path& folder, const TradeoffOptions& options);

}  // namespace restenosis

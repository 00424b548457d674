#pragma once

#include <filesystem>

#include "bridge/flow/FlowBackend.h"
#include "bridge/flow/foam/FoamExecution.h"
#include "bridge/flow/foam/FoamSettings.h"

namespace restenosis {

/// Folder of a case for the case of its beats.
inline constexpr std::string_view beatsFolder = "beats";

/// Goes on from a steady solution through beats, by pimpleFoam on the same mesh, in the case's folder
/// `beats`. The stress of the last two is sampled; that of the last comes into `solution`, whose faces become
/// those of the samples, with the traction that Beating asks for. Throws as FoamRun does.
void solveBeats(const std::filesystem::path& caseFolder, const FlowConditions& conditions,
                const FoamSettings& settings, const FoamExecution& execution, FlowSolution& solution);

}  // namespace restenosis

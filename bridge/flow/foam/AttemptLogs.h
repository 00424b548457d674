#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

namespace restenosis {

/// Folders of a case that keep the logs of an attempt given up: with the former mesh moved, with an O-grid,
/// and the first and the second with a mesh by snappyHexMesh.
inline constexpr std::string_view movedMeshLogs = "movedMesh", oGridLogs = "oGrid",
                                  firstAttemptLogs = "firstAttempt", secondAttemptLogs = "secondAttempt";

/// What a case's folder holds of the attempts to solve it so far, by the file's place in it: the logs of the
/// last attempt, which are to be in the folder `into` from now on, and those kept of others.
std::map<std::filesystem::path, std::string> attemptLogs(const std::filesystem::path& caseFolder,
                                                         std::string_view into);

}  // namespace restenosis

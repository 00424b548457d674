#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace restenosis {

/// The folder of the OpenFOAM case template: $RESTENOSIS_FOAM_CASE where set, else foamCase in dataFolder().
/// Throws std::runtime_error, naming the folder and what it lacks, where it holds no whole template.
std::filesystem::path foamTemplate();

/// What foamTemplate would throw, as the end of a sentence; empty where there is a template.
std::string missingFoamTemplate();
/// The files of a template that a case is filled with, relative to it. Throws
/// std::filesystem::filesystem_error.
std::vector<std::filesystem::path> foamTemplateFiles(const std::filesystem::path& folder);

/// Copies the template into an empty or new folder: 0.orig, constant, system and the scripts, nothing that a
/// run by hand has left there. A folder that holds an earlier case is emptied first. It is filled as
/// `<to>.partial` and then renamed. Throws std::runtime_error where it holds anything else.
void copyFoamTemplate(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace restenosis

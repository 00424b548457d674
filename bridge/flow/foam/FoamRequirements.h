#pragma once

#include <filesystem>
#include <string>

namespace restenosis {

/// What keeps OpenFOAM from running on this machine, as the end of a sentence: a program that is not on the
/// PATH, and the package it belongs to. Empty where all are there.
std::string missingFoamProgram(int ranks);

/// The same for a program that is known to be missing.
std::string missingProgramText(const std::string& program);

/// What keeps OpenFOAM from working in a folder, whether it exists or not: a character of its path that
/// OpenFOAM takes out of every file name. Empty where there is none.
std::string unusableFoamPath(const std::filesystem::path& folder);

}  // namespace restenosis

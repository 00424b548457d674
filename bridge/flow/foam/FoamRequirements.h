#pragma once

#include <string>

namespace restenosis {

/// What keeps OpenFOAM from running on this machine, as the end of a sentence: a program that is not on the
/// PATH, and the package it belongs to; or a WM_PROJECT_DIR without OpenFOAM. Empty where all is there.
std::string missingFoamProgram(int ranks);

/// The same for a program that is known to be missing.
std::string missingProgramText(const std::string& program);

}  // namespace restenosis

#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "bridge/system/ExternalProgram.h"

namespace restenosis {

/// The environment of OpenFOAM's programs, and of MPI's starter of them: what decides results is set here, so
/// that nothing the user has set for other cases (FOAM_*, WM_*, MPI_BUFFER_SIZE, a controlDict in
/// ~/.OpenFOAM, an MPI job that this program is part of) changes them. PATH, libraries and locale stay the
/// user's. The programs run in `folder`, a case.
void setFoamEnvironment(ExternalProgram& program, const std::filesystem::path& folder);

/// The value of PWD by which OpenFOAM finds its case while it runs there: the folder, or where OpenFOAM takes
/// characters out of such names (blanks and quotes), another name that every process has for its own folder.
std::string foamWorkingFolder(const std::filesystem::path& folder);

/// Whether a variable of the user's is kept from OpenFOAM and MPI.
bool isForOtherFoamCases(std::string_view variable);

/// Where OpenFOAM is installed (WM_PROJECT_DIR), for a program of its that was found at this place: the
/// packaged place for packaged programs; otherwise the user's WM_PROJECT_DIR, if OpenFOAM is there.
/// Throws std::runtime_error that names the folders without etc/controlDict, unless the user has named none.
std::string foamProjectFolder(const std::filesystem::path& program);

}  // namespace restenosis

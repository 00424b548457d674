#pragma once

#include <filesystem>

namespace restenosis {

/// Where the files lie that the program reads beside its input: `share/restenosisFoam`, found from the place
/// of the program that runs, so that an installation may be moved. In a build tree the folder holds links
/// into the sources. Where there is none, what is returned is where it should be.
std::filesystem::path dataFolder();

/// The same for a program in the folder `programs`.
std::filesystem::path dataFolder(const std::filesystem::path& programs);

}  // namespace restenosis

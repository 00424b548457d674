#include "bridge/system/DataFolder.h"

#include <array>
#include <system_error>

namespace restenosis {

namespace fs = std::filesystem;

namespace {

/// From the programs to their data: installed, or tests in a build tree; the program in a build tree.
constexpr std::array places = {RESTENOSIS_DATA_FROM_PROGRAMS, "share/restenosisFoam"};

}  // namespace

fs::path dataFolder() {
  std::error_code unknown;
  return dataFolder(fs::read_symlink("/proc/self/exe", unknown).parent_path());
}

fs::path dataFolder(const fs::path& programs) {
  for (const char* place : places) {
    const fs::path folder = (programs / place).lexically_normal();
    std::error_code error;
    if (fs::is_directory(folder, error)) return folder;
  }
  return (programs / places.front()).lexically_normal();
}

}  // namespace restenosis

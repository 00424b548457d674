#include "FoamTemplate.h"

#include <fmt/format.h>

#include <array>
#include <cstdlib>
#include <stdexcept>
#include <vector>

namespace restenosis {

namespace fs = std::filesystem;

namespace {
/// The file by which a folder is known as a case of this template.
const fs::path mark = "system/lumenParameters";
}  // namespace

fs::path foamTemplate() {
  std::vector<fs::path> candidates;
  if (const char* folder = std::getenv("RESTENOSIS_FOAM_CASE")) {
    candidates = {folder};
  } else {
    std::error_code ignored;
    const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
    if (!ignored) candidates.push_back(program.parent_path().parent_path() / "share/restenosisFoam/foamCase");
    candidates.push_back(RESTENOSIS_FOAM_CASE_DIR);
  }
  std::string tried;
  for (const auto& folder : candidates) {
    if (fs::is_regular_file(folder / mark)) return folder;
    tried += fmt::format(" {}", folder.string());
  }
  throw std::runtime_error(fmt::format("no OpenFOAM case template (with {}) in:{}", mark.string(), tried));
}

void copyFoamTemplate(const fs::path& from, const fs::path& to) {
  // Filled under another name: whenever the program is killed, the folder is whole or not there
  fs::path partial = to.has_filename() ? to : to.parent_path();
  partial += ".partial";
  fs::remove_all(partial);
  if (fs::exists(to)) {
    if (!fs::is_empty(to) && !fs::is_regular_file(to / mark))
      throw std::runtime_error(
          fmt::format("{} holds files that are no flow case; choose another folder", to.string()));
    fs::rename(to, partial);
    fs::remove_all(partial);
  }
  static constexpr std::array parts = {"0.orig",
                                       "system",
                                       "constant/transportProperties",
                                       "constant/turbulenceProperties",
                                       "Allrun",
                                       "Allclean",
                                       "makeExampleLumen",
                                       "README.md"};
  fs::create_directories(partial / "constant/triSurface");
  for (const char* part : parts)
    fs::copy(from / part, partial / part, fs::copy_options::recursive | fs::copy_options::overwrite_existing);
  fs::rename(partial, to);
}

}  // namespace restenosis

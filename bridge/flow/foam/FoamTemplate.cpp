#include "bridge/flow/foam/FoamTemplate.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <stdexcept>
#include <vector>

namespace restenosis {

namespace fs = std::filesystem;

namespace {
/// The file by which a folder is known as a case of this template.
const fs::path mark = "system/lumenParameters";

/// What a case is copied from.
constexpr std::array parts = {"0.orig",
                              "system",
                              "constant/transportProperties",
                              "constant/turbulenceProperties",
                              "Allrun",
                              "Allclean",
                              "makeExampleLumen",
                              "README.md"};

/// What a folder lacks of a template; empty where it is one.
std::string missingPart(const fs::path& folder) {
  std::error_code error;
  if (!fs::is_regular_file(folder / mark, error)) return mark.string();
  const auto found =
      std::ranges::find_if(parts, [&](auto part) { return !fs::exists(folder / part, error); });
  return found == parts.end() ? "" : *found;
}
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
    const std::string missing = missingPart(folder);
    if (missing.empty()) return folder;
    tried += fmt::format("{} {} (lacks {})", tried.empty() ? "" : ",", folder.string(), missing);
  }
  throw std::runtime_error(fmt::format(
      "there is no whole OpenFOAM case template in{}; RESTENOSIS_FOAM_CASE names the folder of another",
      tried));
}

std::string missingFoamTemplate() {
  try {
    foamTemplate();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

std::vector<fs::path> foamTemplateFiles(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const char* part : parts) {
    if (fs::is_regular_file(folder / part)) files.emplace_back(part);
    if (!fs::is_directory(folder / part)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(folder / part))
      if (entry.is_regular_file()) files.push_back(entry.path().lexically_relative(folder));
  }
  return files;
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
  fs::create_directories(partial / "constant/triSurface");
  for (const char* part : parts)
    fs::copy(from / part, partial / part, fs::copy_options::recursive | fs::copy_options::overwrite_existing);
  fs::rename(partial, to);
}

}  // namespace restenosis

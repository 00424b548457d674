#include "bridge/flow/foam/FoamTemplate.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <stdexcept>
#include <vector>

#include "bridge/system/DataFolder.h"

namespace restenosis {

namespace fs = std::filesystem;

namespace {
/// The file by which a folder is known as a case of this template.
const fs::path mark = "system/lumenParameters";

/// What a case is copied from.
constexpr std::array parts = {"0.orig",
                              "system",
                              "beats",
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
  const char* chosen = std::getenv("RESTENOSIS_FOAM_CASE");
  const fs::path folder = chosen ? fs::path(chosen) : dataFolder() / "foamCase";
  const std::string missing = missingPart(folder);
  if (missing.empty()) return folder;
  throw std::runtime_error(
      fmt::format("there is no whole OpenFOAM case template in {} (lacks {}); RESTENOSIS_FOAM_CASE names the "
                  "folder of another",
                  folder.string(), missing));
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

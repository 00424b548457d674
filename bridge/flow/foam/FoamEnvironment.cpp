#include "bridge/flow/foam/FoamEnvironment.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <stdexcept>

namespace restenosis {

namespace fs = std::filesystem;

namespace {

constexpr const char* packagedProject = "/usr/share/openfoam";
/// Every process's own working folder, as Linux names it.
constexpr const char* ownFolder = "/proc/self/cwd";

std::string valueOf(const char* variable) {
  const char* value = std::getenv(variable);
  return value ? value : "";
}

bool holdsOpenFoam(const fs::path& project) {
  std::error_code ignored;
  return fs::is_regular_file(project / "etc/controlDict", ignored);
}

bool isPackaged(const fs::path& program) {
  std::error_code ignored;
  return fs::canonical(program, ignored).parent_path() == "/usr/bin";
}

/// Whether MPI has started this program, whose variables then are of that job and not of the next.
bool withinMpiJob() {
  constexpr std::array marks = {"OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMI_RANK"};
  return std::ranges::any_of(marks, [](const char* variable) { return std::getenv(variable) != nullptr; });
}

bool startsWithOneOf(std::string_view variable, const auto& prefixes) {
  return std::ranges::any_of(prefixes, [&](std::string_view p) { return variable.starts_with(p); });
}

}  // namespace

bool isForOtherFoamCases(std::string_view variable) {
  constexpr std::array<std::string_view, 3> ofFoam = {"FOAM_", "WM_", "MPI_BUFFER_SIZE"};
  constexpr std::array<std::string_view, 7> ofMpiJobs = {"OMPI_",    "PMIX_",  "PMI_",     "PRTE_",
                                                         "MPIEXEC_", "HYDRA_", "MPI_LOCAL"};
  return startsWithOneOf(variable, ofFoam) || (withinMpiJob() && startsWithOneOf(variable, ofMpiJobs));
}

std::string foamWorkingFolder(const fs::path& folder) {
  const std::string path = fs::canonical(folder).string();
  return path.find_first_of(" \t\n\v\f\r\"'") == std::string::npos ? path : ownFolder;
}

std::string foamProjectFolder(const fs::path& program) {
  if (isPackaged(program) && holdsOpenFoam(packagedProject)) return packagedProject;
  const std::string users = valueOf("WM_PROJECT_DIR");
  if (!users.empty() && holdsOpenFoam(users)) return users;
  if (users.empty() || holdsOpenFoam(packagedProject)) return packagedProject;
  throw std::runtime_error(
      fmt::format("OpenFOAM is not where WM_PROJECT_DIR says: neither {} nor {} holds its etc/controlDict",
                  users, packagedProject));
}

void setFoamEnvironment(ExternalProgram& program, const fs::path& folder) {
  program.withoutEnvironment(isForOtherFoamCases);
  program.setEnvironment("PWD", foamWorkingFolder(folder));
  // Where OpenFOAM looks for a user's own etc files, and MPI for a user's own parameters: there are none here
  program.setEnvironment("HOME", ownFolder);
  program.setEnvironment("FOAM_FILEHANDLER", "uncollated");
  program.setEnvironment("FOAM_SIGFPE", "true");
  program.setEnvironment("FOAM_SETNAN", "false");
}

}  // namespace restenosis

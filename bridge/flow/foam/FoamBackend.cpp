#include "FoamBackend.h"

#include <fmt/format.h>

#include <fstream>

#include "FlowBackendNames.h"
#include "FoamLog.h"
#include "FoamRun.h"
#include "FoamTemplate.h"
#include "FoamVelocity.h"
#include "LumenCase.h"
#include "LumenStl.h"

namespace restenosis {

namespace fs = std::filesystem;

namespace {

/// Cells by which the wall overshoots the planes of the ends.
constexpr double overshootCells = 2.0;
/// Largest velocity that the inlet's profile may have on the rim, over that in the centre, without a remark.
constexpr double rimErrorRemark = 0.02;

void writeText(const fs::path& file, const std::string& text) {
  std::ofstream stream(file, std::ios::binary);
  stream << text;
  stream.close();
  if (!stream) throw std::runtime_error(fmt::format("cannot write {}", file.string()));
}

}  // namespace

std::string_view FoamBackend::name() const { return flowBackendNames::foam; }

FlowSolution FoamBackend::solve(const TriSurface& lumen, const FlowConditions& conditions,
                                const fs::path& caseFolder) {
  LumenCase shape;
  try {
    shape = measureLumen(lumen, settings_);
  } catch (const std::invalid_argument& error) {
    throw FlowFailed(fmt::format("OpenFOAM case: {}", error.what()), {});
  }
  const fs::path folder = fs::absolute(caseFolder);
  solved_ = folder;
  try {
    return attempt(folder, lumen, shape, conditions, Effort::normal);
  } catch (const FoamStepFailed& first) {
    try {
      FlowSolution solution = attempt(folder, lumen, shape, conditions, Effort::robust);
      solution.remarks.push_back(fmt::format(
          "solved at the second attempt, with thorough meshing and stronger relaxation; the first: {}",
          first.what()));
      return solution;
    } catch (const FlowFailed& second) {
      const fs::path former = folder / "firstAttempt" / first.log.filename();
      throw FlowFailed(fmt::format("{}; a first attempt with the usual settings had failed too: {}",
                                   second.what(), first.what()),
                       second.log.empty() ? former : second.log);
    }
  }
}

std::vector<Vec3> FoamBackend::velocities(const std::vector<Vec3>& points) const {
  if (solved_.empty()) return {};
  return foamVelocities(solved_, points);
}

void FoamBackend::prepare(const fs::path& folder, const TriSurface& surface, const LumenCase& lumen,
                          const FlowConditions& conditions, Effort effort) const {
  std::vector<std::pair<fs::path, std::string>> kept;
  if (effort == Effort::robust)
    for (const auto& entry : fs::directory_iterator(folder))
      if (entry.path().filename().string().starts_with("log."))
        kept.emplace_back(entry.path().filename(), foamLog::read(entry.path()));
  copyFoamTemplate(foamTemplate(), folder);
  if (!kept.empty()) fs::create_directories(folder / "firstAttempt");
  for (const auto& [name, text] : kept) writeText(folder / "firstAttempt" / name, text);

  const auto file = folder / "system/lumenParameters";
  DictionaryText parameters(foamLog::read(file));
  writeLumenParameters(parameters, lumen, conditions, settings_, effort, execution_.ranks);
  writeText(file, parameters.text());
  const fs::path surfaces = folder / "constant/triSurface";
  writeLumenStl(surface, lumen.ends, overshootCells * settings_.cellSize, surfaces / "lumen.stl");
  if (lumen.ends != LumenEnds::cut) writeRims(surface, lumen.ends, surfaces / "rims.obj");
  writeText(folder / "case.foam", "");
}

FlowSolution FoamBackend::attempt(const fs::path& folder, const TriSurface& surface, const LumenCase& lumen,
                                  const FlowConditions& conditions, Effort effort) const {
  try {
    prepare(folder, surface, lumen, conditions, effort);
    FoamRun run(folder, lumen, conditions, settings_, execution_);
    run.mesh();
    run.solve();
    FlowSolution solution = run.result();
    const bool profiled = conditions.drive == FlowConditions::Drive::flowRate;
    if (profiled && lumen.profile.rimError > rimErrorRemark)
      solution.remarks.push_back(fmt::format(
          "the inlet's velocity profile misses zero on its rim by {:.2g} % of that in the centre: "
          "the inlet's shape is far from round",
          100.0 * lumen.profile.rimError));
    return solution;
  } catch (const FlowFailed&) {
    throw;
  } catch (const std::exception& error) {  // files that cannot be written or copied
    throw FlowFailed(fmt::format("OpenFOAM case: {}", error.what()), {});
  }
}

}  // namespace restenosis

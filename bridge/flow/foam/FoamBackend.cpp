#include "bridge/flow/foam/FoamBackend.h"

#include <fmt/format.h>

#include <array>
#include <optional>

#include "bridge/flow/FlowBackendNames.h"
#include "bridge/flow/LumenWidth.h"
#include "bridge/flow/foam/AttemptLogs.h"
#include "bridge/flow/foam/FoamBeats.h"
#include "bridge/flow/foam/FoamLog.h"
#include "bridge/flow/foam/FoamOutlets.h"
#include "bridge/flow/foam/FoamRun.h"
#include "bridge/flow/foam/FoamTemplate.h"
#include "bridge/flow/foam/FoamVelocity.h"
#include "bridge/flow/foam/LumenCase.h"
#include "bridge/flow/foam/LumenStl.h"
#include "bridge/flow/foam/MeshMorph.h"
#include "bridge/flow/foam/WomersleyProfile.h"
#include "bridge/system/AtomicFile.h"

namespace restenosis {

namespace fs = std::filesystem;

namespace {

/// Cells by which the wall overshoots the planes of the ends.
constexpr double overshootCells = 2.0;
/// Largest velocity that the inlet's profile may have on the rim, over that well inside, without a remark.
constexpr double rimErrorRemark = 0.02;
/// Fewest cells at the wall across the lumen without a remark (docs/model/flow.md).
constexpr double fewestWithoutRemark = 4.0;

/// Whether the mesh was what failed: with other cells it may not.
bool isOfMesh(const FoamStepFailed& failed) {
  const std::string log = failed.log.filename().string();
  return log == "log.snappyHexMesh" || log == "log.checkMesh";
}

/// Whether so many cells are allowed.
bool canBeMeshed(const TriSurface& lumen, const FoamSettings& settings) {
  try {
    measureLumen(lumen, settings);
    return true;
  } catch (const std::invalid_argument&) {
    return false;
  }
}

std::string narrowness(const TriSurface& lumen, const FoamSettings& settings) {
  return narrownessRemark(
      lumen, {settings.wallCell(), "cells at the wall", fewestWithoutRemark,
              "a finer scene.fidelity, a higher foam.wallLevel or a smaller foam.cellSize resolves it"});
}

}  // namespace

/// What an attempt changes after one that failed.
struct FoamBackend::FurtherAttempt {
  const char *name, *means;
  double cells;  ///< their size over that of the settings
  std::string_view keepLogsIn;
};

namespace {

/// A single bad face of a mesh depends on where the cells happen to lie (assumed: cells smaller by that
/// much).
constexpr double otherCells = 0.93;

/// Part of the mean velocity that the inlet may miss of Womersley's profile, and of the stress that may
/// change from one beat to the next, before it is said (assumed).
constexpr double profileErrorRemark = 0.01, beatChangeRemark = 0.01;

void remarkOnBeats(FlowSolution& solution, const FlowConditions& conditions, double radius) {
  if (const double error = womersleyProfile(conditions, radius).error; error > profileErrorRemark)
    solution.remarks.push_back(fmt::format(
        "the inlet's velocity misses Womersley's profile by {:.2g} % of the mean velocity: the lumen is "
        "wide, or beats fast, and the profile steep at the wall",
        100 * error));
  if (solution.beats.change > beatChangeRemark)
    solution.remarks.push_back(
        fmt::format("the stress of the last beat differs from that of the one before by {:.2g} %: more "
                    "flow.beats are needed",
                    100 * solution.beats.change));
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
  const std::string narrow = narrowness(lumen, settings_);
  try {
    FlowSolution solution = solveMeasured(lumen, shape, conditions, fs::absolute(caseFolder));
    if (!narrow.empty()) solution.remarks.push_back(narrow);
    return solution;
  } catch (const FlowFailed& error) {
    if (narrow.empty()) throw;
    throw FlowFailed(fmt::format("{}; {}", error.what(), narrow), error.log);
  }
}

FlowSolution FoamBackend::solveMeasured(const TriSurface& lumen, const LumenCase& shape,
                                        const FlowConditions& conditions, const fs::path& folder) {
  solved_ = folder;
  std::optional<Former> former;
  std::string reason = "there was no former mesh", details;
  if (!former_.empty()) {
    try {
      former.emplace(former_, readFoamSolution(former_));
    } catch (const std::exception& error) {
      reason = "the former case could not be read", details = error.what();
    }
  }
  Attempt newMesh{.former = former && settings_.warmStart ? &*former : nullptr};
  if (settings_.mesh == "oGrid") {
    newMesh.keepLogsIn = oGridLogs;
    try {
      return attempt(folder, lumen, shape, conditions,
                     {.mesh = Attempt::Mesh::oGrid, .former = newMesh.former});
    } catch (const MeshRefused& refused) {
      reason = refused.reason, details = refused.what();
    } catch (const FoamStepFailed& failed) {
      reason = "the O-grid failed a check", details = failed.withLogIn(folder / oGridLogs);
    }
  } else if (remeshing_ == Remeshing::onDemand && former) {
    newMesh.keepLogsIn = movedMeshLogs;
    try {
      return attempt(folder, lumen, shape, conditions, {.mesh = Attempt::Mesh::moved, .former = &*former});
    } catch (const MeshRefused& refused) {
      reason = refused.reason, details = refused.what();
    } catch (const FoamStepFailed& failed) {
      reason = "the moved mesh failed a check", details = failed.withLogIn(folder / movedMeshLogs);
    }
  }
  FlowSolution solution = solveWithNewMesh(folder, lumen, shape, conditions, newMesh);
  const bool onDemand = remeshing_ == Remeshing::onDemand || settings_.mesh == "oGrid";
  if (onDemand) solution.remeshedBecause = reason;
  if (!details.empty())
    solution.remarks.push_back(
        fmt::format("{}: {} ({})", onDemand ? "meshed again" : "started from rest", reason, details));
  return solution;
}

FlowSolution FoamBackend::solveWithNewMesh(const fs::path& folder, const TriSurface& lumen,
                                           const LumenCase& shape, const FlowConditions& conditions,
                                           const Attempt& how) const {
  try {
    return attempt(folder, lumen, shape, conditions, how);
  } catch (const FoamStepFailed& first) {
    static constexpr std::array<FurtherAttempt, 2> furtherAttempts{
        {{"second", "thorough meshing and stronger relaxation", 1.0, firstAttemptLogs},
         {"third", "the same and other cells", otherCells, secondAttemptLogs}}};
    return solveOnceMore(folder, lumen, conditions, furtherAttempts,
                         fmt::format("a first attempt with the usual settings had failed too: {}",
                                     first.withLogIn(folder / firstAttemptLogs)),
                         folder / firstAttemptLogs / first.log.filename());
  }
}

FlowSolution FoamBackend::solveOnceMore(const fs::path& folder, const TriSurface& lumen,
                                        const FlowConditions& conditions,
                                        std::span<const FurtherAttempt> attempts, const std::string& before,
                                        const fs::path& logBefore) const {
  const FurtherAttempt& now = attempts.front();
  try {
    FlowSolution solution =
        attempt(folder, lumen, measureLumen(lumen, settingsFor(now.cells)), conditions,
                {.effort = Effort::robust, .cells = now.cells, .keepLogsIn = now.keepLogsIn});
    solution.remarks.push_back(
        fmt::format("solved at the {} attempt, with {}; {}", now.name, now.means, before));
    return solution;
  } catch (const WriteFailed& failed) {  // what was wanting may have ended the one before
    throw WriteFailed(fmt::format("{}; {}", failed.what(), before));
  } catch (const FoamStepFailed& failed) {
    if (attempts.size() == 1 || !isOfMesh(failed) || !canBeMeshed(lumen, settingsFor(attempts[1].cells)))
      throw FlowFailed(fmt::format("{}; {}", failed.what(), before), failed.log);
    const fs::path kept = folder / attempts[1].keepLogsIn;
    return solveOnceMore(folder, lumen, conditions, attempts.subspan(1),
                         fmt::format("the {} attempt, with {}, had failed: {}; {}", now.name, now.means,
                                     failed.withLogIn(kept), before),
                         kept / failed.log.filename());
  } catch (const FlowFailed& failed) {
    throw FlowFailed(fmt::format("{}; {}", failed.what(), before),
                     failed.log.empty() ? logBefore : failed.log);
  }
}

FoamSettings FoamBackend::settingsFor(double cells) const {
  FoamSettings settings = settings_;
  settings.cellSize *= cells;
  return settings;
}

void FoamBackend::startFrom(const fs::path& formerCase) { former_ = fs::absolute(formerCase); }

bool FoamBackend::needsFormerCase() const { return settings_.warmStart || remeshing_ == Remeshing::onDemand; }

std::vector<fs::path> FoamBackend::filesToStartFrom(const fs::path& formerCase) const {
  return foamSolutionFiles(formerCase);
}

std::vector<Vec3> FoamBackend::velocities(const std::vector<Vec3>& points) const {
  if (solved_.empty()) return {};
  return foamVelocities(solved_, points);
}

void FoamBackend::prepare(const fs::path& folder, const TriSurface& surface, const LumenCase& lumen,
                          const FlowConditions& conditions, const Attempt& how) const {
  std::map<fs::path, std::string> logs;
  if (!how.keepLogsIn.empty()) logs = attemptLogs(folder, how.keepLogsIn);
  copyFoamTemplate(foamTemplate(), folder);
  if (!conditions.beating) fs::remove_all(folder / beatsFolder);
  for (const auto& [file, text] : logs) {
    fs::create_directories((folder / file).parent_path());
    atomicWrite(folder / file, text);
  }

  const auto file = folder / "system/lumenParameters";
  DictionaryText parameters(foamLog::read(file));
  const FoamSettings settings = settingsFor(how.cells);
  writeLumenParameters(parameters, lumen, conditions, settings, how.effort, execution_.ranks);
  atomicWrite(file, parameters.text());
  const auto outlets = folder / "system/outlets";
  atomicWrite(outlets, outletsText(foamLog::read(outlets), conditions));
  const fs::path surfaces = folder / "constant/triSurface";
  writeLumenStl(surface, lumen.ends, overshootCells * settings.cellSize, surfaces / "lumen.stl");
  if (lumen.ends != LumenEnds::cut) writeRims(surface, lumen.ends, surfaces / "rims.obj");
  atomicWrite(folder / "case.foam", "");
}

FlowSolution FoamBackend::attempt(const fs::path& folder, const TriSurface& surface, const LumenCase& lumen,
                                  const FlowConditions& conditions, const Attempt& how) const {
  const bool moved = how.mesh == Attempt::Mesh::moved;
  try {
    prepare(folder, surface, lumen, conditions, how);
    const FoamSettings settings = settingsFor(how.cells);
    FoamRun run(folder, lumen, conditions, settings, execution_);
    std::optional<FoamStart> start;
    if (moved) {
      auto centres = run.morph(how.former->solution.mesh, how.former->folder, surface);
      if (settings_.warmStart) start.emplace(how.former->solution, std::move(centres));
    } else {
      if (how.mesh == Attempt::Mesh::oGrid)
        run.layOGrid(surface);
      else
        run.mesh();
      if (how.former != nullptr) start.emplace(how.former->solution, how.former->solution.mesh.cellCentres());
    }
    run.solve(start ? &*start : nullptr);
    FlowSolution solution = run.result();
    if (conditions.beating) solveBeats(folder, conditions, settings, execution_, solution);
    if (moved) takeRegions(solution.wall, surface);
    const bool profiled = conditions.drive == FlowConditions::Drive::flowRate;
    if (profiled && lumen.profile.rimError > rimErrorRemark)
      solution.remarks.push_back(
          fmt::format("the inlet's velocity profile misses zero on its rim by {:.2g} % of that well inside: "
                      "the inlet's shape is far from round",
                      100.0 * lumen.profile.rimError));
    if (conditions.beating) remarkOnBeats(solution, conditions, lumen.profile.radius);
    return solution;
  } catch (const FlowFailed&) {
    throw;
  } catch (const MeshRefused&) {
    throw;
  } catch (const WriteFailed&) {
    throw;
  } catch (const fs::filesystem_error& error) {  // files that cannot be copied
    if (const int number = error.code().value(); isForWantOfRoom(number))
      throw WriteFailed(fmt::format("cannot write into {}: {}", folder.string(), writeFailureReason(number)));
    throw FlowFailed(fmt::format("OpenFOAM case: {}", error.what()), {});
  } catch (const std::exception& error) {
    throw FlowFailed(fmt::format("OpenFOAM case: {}", error.what()), {});
  }
}

}  // namespace restenosis

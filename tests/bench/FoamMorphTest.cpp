// Cost and wall shear stress of a mesh that follows a growing lumen, beside new meshes of the same lumens.
// The lumens are those that a run has recorded: RESTENOSIS_RESULTS names its folder, RESTENOSIS_FROM_DAY (3)
// the first, RESTENOSIS_EVERY (1) takes only every n-th, RESTENOSIS_FIDELITY (draft) is the mesh. Prints a
// table.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cstdlib>
#include <limits>

#include "bridge/compare/LumenFile.h"
#include "bridge/flow/foam/FoamBackend.h"
#include "bridge/surface/PointTree.h"
#include "tests/support/FlowSupport.h"
#include "tests/support/OpenFoamPresent.h"
#include "tests/support/TemporaryFolder.h"

namespace restenosis::support {
namespace {

using Remeshing = FoamBackend::Remeshing;

std::string setting(const char* variable, const char* otherwise) {
  const char* value = std::getenv(variable);
  return value ? value : otherwise;
}

/// CPU time of this process and of those that it has started and that have ended [s].
double cpuSeconds() {
  double sum = 0.0;
  for (const int whose : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
    rusage usage{};
    getrusage(whose, &usage);
    for (const timeval& t : {usage.ru_utime, usage.ru_stime})
      sum += static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  }
  return sum;
}

/// CPU time of simpleFoam, as it reports it [s].
double solverSeconds(const std::filesystem::path& folder) {
  const std::string log = readText(folder / "log.simpleFoam"), words = "ExecutionTime = ";
  const auto at = log.rfind(words);
  return at == std::string::npos ? 0.0 : std::stod(log.substr(at + words.size()));
}

/// One way to solve the lumens one after another.
struct Way {
  const char* name;
  Remeshing remeshing;
  bool warmStart;
  const char* comparedWith;  ///< an earlier way; null for none

  FlowSolution last = {};
  std::filesystem::path folder = {};
  double cpu = 0, solver = 0, iterations = 0, meanDifference = 0, medianDifference = 0, l2Difference = 0;
  int moved = 0;
};

/// Adds the difference of the stress on the wall from that of `b` on the nearest faces.
void compare(Way& way, const FlowSolution& b) {
  std::vector<Vec3> centres;
  std::vector<double> stress, relative;
  double mean = 0, ownMean = 0, area = 0, ownArea = 0, square = 0;
  for (const WallFace& f : b.wall) {
    if (f.region != SurfaceRegion::wall) continue;
    centres.push_back(f.centre);
    stress.push_back(f.traction.norm());
    mean += f.area * f.traction.norm(), area += f.area;
  }
  mean /= area;
  const PointTree tree(centres);
  for (const WallFace& f : way.last.wall) {
    if (f.region != SurfaceRegion::wall) continue;
    const double own = f.traction.norm(), other = stress[tree.nearest(f.centre, 1).front().index];
    ownMean += f.area * own, ownArea += f.area;
    square += f.area * (own - other) * (own - other);
    relative.push_back(std::abs(own - other) / mean);
  }
  std::ranges::nth_element(relative, relative.begin() + static_cast<std::ptrdiff_t>(relative.size() / 2));
  way.meanDifference += ownMean / ownArea / mean - 1.0;
  way.medianDifference += relative[relative.size() / 2];
  way.l2Difference += std::sqrt(square / ownArea) / mean;
}

TEST(FoamMorph, costAndDifference) {
  RESTENOSIS_NEEDS_OPENFOAM();
  const std::string results = setting("RESTENOSIS_RESULTS", "");
  if (results.empty()) GTEST_SKIP() << "RESTENOSIS_RESULTS names no run whose lumens could be solved";
  const double from = std::stod(setting("RESTENOSIS_FROM_DAY", "3"));
  const int every = std::stoi(setting("RESTENOSIS_EVERY", "1"));
  const auto fidelity = setting("RESTENOSIS_FIDELITY", "draft");
  const TemporaryFolder scratch;
  std::vector<Way> ways = {
      {"new mesh, from rest", Remeshing::always, false, nullptr},
      {"new mesh, from the former flow", Remeshing::always, true, "new mesh, from rest"},
      {"moved mesh, from rest", Remeshing::onDemand, false, "new mesh, from rest"},
      {"moved mesh, from the former flow", Remeshing::onDemand, true, "moved mesh, from rest"},
  };
  int lumens = 0, position = 0;
  for (const RecordedLumen& recorded : recordedLumens(results)) {
    if (recorded.day < from - 1e-9 || position++ % every != 0) continue;
    const TriSurface lumen = readLumen(recorded.file);
    for (Way& way : ways) {
      FoamSettings settings = FoamSettings::forFidelity(fidelity);
      settings.warmStart = way.warmStart;
      FoamBackend backend(settings, {}, way.remeshing);
      if (!way.folder.empty()) backend.startFrom(way.folder);
      // OpenFOAM takes no spaces in names of folders
      const auto folder = scratch / fmt::format("way{}_{}", &way - ways.data(), lumens);
      const double begin = cpuSeconds();
      FlowSolution solution = backend.solve(lumen, vesselConditions(), folder);
      const double seconds = cpuSeconds() - begin;
      const auto former = std::exchange(way.folder, folder);
      if (!former.empty()) std::filesystem::remove_all(former);
      for (const auto& remark : solution.remarks)
        std::printf("day %.4f, %s: %s\n", recorded.day, way.name, remark.c_str());
      way.last = std::move(solution);
      if (lumens == 0) continue;
      way.cpu += seconds, way.solver += solverSeconds(folder);
      way.iterations += way.last.iterations, way.moved += way.last.meshMoved;
      for (const Way& other : ways)
        if (way.comparedWith != nullptr && std::string_view(other.name) == way.comparedWith)
          compare(way, other.last);
    }
    std::fflush(stdout);
    ++lumens;
  }
  ASSERT_GT(lumens, 1);
  const double n = lumens - 1;  // the first has no former one
  std::printf(
      "%zu cells, %g lumens after the first; CPU seconds of one solve, means; differences of the stress on "
      "the wall "
      "from the way named last\n%-34s moved  others_s solver_s iterations  mean_%% median_%%   L2_%%\n",
      ways[0].last.cells, n, "way");
  for (const Way& way : ways)
    std::printf("%-34s %5d %8.2f %8.2f %10.1f %7.3f %8.3f %6.3f  %s\n", way.name, way.moved,
                (way.cpu - way.solver) / n, way.solver / n, way.iterations / n, 100 * way.meanDifference / n,
                100 * way.medianDifference / n, 100 * way.l2Difference / n,
                way.comparedWith ? way.comparedWith : "");
  EXPECT_LT(std::abs(ways[2].meanDifference / n), 0.02);
  EXPECT_GT(ways[3].moved, 0);
}

}  // namespace
}  // namespace restenosis::support

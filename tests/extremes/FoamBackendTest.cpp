#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <limits>

#include "bridge/flow/foam/CellEstimate.h"
#include "bridge/flow/foam/FoamBackend.h"
#include "bridge/flow/foam/FoamLog.h"
#include "bridge/flow/foam/FoamRun.h"
#include "bridge/flow/foam/FoamTemplate.h"
#include "bridge/flow/foam/LumenStl.h"
#include "tests/support/EnvironmentVariable.h"
#include "tests/support/ExpectSays.h"
#include "tests/support/FlowSupport.h"
#include "tests/support/OpenFoamPresent.h"
#include "tests/support/TemporaryFolder.h"
#include "tests/support/TubeSurface.h"

namespace restenosis {
namespace {

using namespace support;
namespace fs = std::filesystem;

FoamSettings draft() { return FoamSettings::forFidelity("draft"); }

/// What the backend says when the flow fails; empty when it does not.
std::string failure(const TriSurface& lumen, const fs::path& folder, FoamSettings settings = draft(),
                    fs::path* log = nullptr) {
  try {
    FoamBackend(settings).solve(lumen, vesselConditions(), folder);
  } catch (const FlowFailed& error) {
    if (log) *log = error.log;
    return error.what();
  }
  return "";
}

/// The PATH for the length of a test.
class PathOnly {
 public:
  explicit PathOnly(const fs::path& folder) : before_(std::getenv("PATH")) {
    setenv("PATH", folder.c_str(), 1);
  }
  ~PathOnly() { setenv("PATH", before_.c_str(), 1); }

 private:
  std::string before_;
};

TEST(FoamBackendFaults, holeAndNanAndScaleAreFoundBeforeMeshing) {
  const TemporaryFolder scratch;
  auto hole = tube(vesselRadius, vesselLength);
  hole.triangles.erase(hole.triangles.begin() + 100);
  hole.region.erase(hole.region.begin() + 100);
  EXPECT_SAYS(failure(hole, scratch.path() / "hole"), "not closed");
  auto nan = tube(vesselRadius, vesselLength);
  nan.vertices[50].y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_SAYS(failure(nan, scratch.path() / "nan"), "not a number");
  EXPECT_SAYS(failure(tube(1e3 * vesselRadius, 1e3 * vesselLength), scratch.path() / "large"), "length unit");
  EXPECT_SAYS(failure(tube(1e-3 * vesselRadius, 1e-3 * vesselLength), scratch.path() / "small"),
              "length unit");
  EXPECT_TRUE(fs::is_empty(scratch.path()));
}

/// What is said of a case whose surface or numbers are not those of the lumen that it was written for; empty
/// when it is meshed. `change` makes them so.
template <class Change>
std::string meshingFailure(const Change& change) {
  const TemporaryFolder scratch;
  const auto folder = scratch.path() / "case";
  TriSurface surface = tube(vesselRadius, vesselLength);
  const auto lumen = measureLumen(surface, draft());
  copyFoamTemplate(foamTemplate(), folder);
  DictionaryText parameters(foamLog::read(folder / "system/lumenParameters"));
  writeLumenParameters(parameters, lumen, vesselConditions(), draft(), Effort::normal, 1);
  change(surface, parameters);
  std::ofstream(folder / "system/lumenParameters") << parameters.text();
  writeLumenStl(surface, LumenEnds::cut, 0.2e-3, folder / "constant/triSurface/lumen.stl");
  try {
    FoamRun(folder, lumen, vesselConditions(), draft(), {}).mesh();
  } catch (const FoamStepFailed& error) {
    return error.what();
  }
  return "";
}

TEST(FoamBackendFaults, leakingMeshIsFound) {
  RESTENOSIS_NEEDS_OPENFOAM();
  EXPECT_SAYS(meshingFailure([](TriSurface& surface, DictionaryText&) {
                const auto first = 5 * 256, count = 2 * 6;  // six quadrilaterals half way along
                surface.triangles.erase(surface.triangles.begin() + first,
                                        surface.triangles.begin() + first + count);
                surface.region.erase(surface.region.begin() + first, surface.region.begin() + first + count);
              }),
              "leaks");
}

TEST(FoamBackendFaults, aPointOutsideIsFound) {
  RESTENOSIS_NEEDS_OPENFOAM();
  const auto outsideBlock =
      meshingFailure([](TriSurface&, DictionaryText& p) { p.set("insidePoint", "(0.05 0.05 0.05)"); });
  EXPECT_SAYS(outsideBlock, "snappyHexMesh");
  EXPECT_SAYS(outsideBlock, "not inside the mesh");
  // In a corner of the block, outside the lumen: OpenFOAM meshes what is around it, and all is well
  EXPECT_SAYS(meshingFailure([](TriSurface&, DictionaryText& p) {
                p.set("insidePoint", "(-0.951e-3 -0.947e-3 0.611e-3)");
              }),
              "leaks");
}

/// The volume is that of the lumen measured, so that the ends alone tell.
TEST(FoamBackendFaults, otherEndsThanTheLumensAreFound) {
  RESTENOSIS_NEEDS_OPENFOAM();
  EXPECT_SAYS(meshingFailure([](TriSurface& surface, DictionaryText&) {
                // Ends narrower than the middle: as much volume as the tube of radius 0.9 mm
                surface = revolve({{0.8e-3, 0},
                                   {0.8e-3, 0.1e-3},
                                   {0.947e-3, 0.3e-3},
                                   {0.947e-3, 0.9e-3},
                                   {0.8e-3, 1.1e-3},
                                   {0.8e-3, vesselLength}});
              }),
              "the mesh's inlet of");
}

/// As with the limit of cases whose lengths are metres: it is absolute.
TEST(FoamBackendFaults, illegalFacesAreFound) {
  RESTENOSIS_NEEDS_OPENFOAM();
  EXPECT_SAYS(meshingFailure([](TriSurface&, DictionaryText& p) { p.set("minVolume", "1e-13"); }), "illegal");
}

TEST(FoamBackendFaults, occlusionIsNamed) {
  RESTENOSIS_NEEDS_OPENFOAM();
  const TemporaryFolder scratch;
  const double closed = 1e-5 * vesselRadius;
  const auto lumen = revolve({{vesselRadius, 0},
                              {vesselRadius, 0.3e-3},
                              {closed, 0.6e-3},
                              {closed, 0.7e-3},
                              {vesselRadius, 0.9e-3},
                              {vesselRadius, vesselLength}});
  const auto message = failure(lumen, scratch.path() / "case");
  EXPECT_SAYS(message, "closed");
  EXPECT_SAYS(message, "outlet");
}

TEST(FoamBackendFaults, cellsTooLargeForTheLumenAreNamed) {
  RESTENOSIS_NEEDS_OPENFOAM();
  const TemporaryFolder scratch;
  const auto message = failure(tube(65e-6, 0.5e-3), scratch / "case");
  EXPECT_SAYS(message, "too large for so narrow a lumen");
  EXPECT_SAYS(message, "the lumen is 130 um wide, 2.9 cells at the wall of 45 um");
}

TEST(FoamBackendFaults, unconvergedSolutionIsNoResult) {
  RESTENOSIS_NEEDS_OPENFOAM();
  const TemporaryFolder scratch;
  FoamSettings settings = draft();
  settings.iterations = 3;
  fs::path log;
  const auto message = failure(tube(vesselRadius, vesselLength), scratch.path() / "case", settings, &log);
  EXPECT_SAYS(message, "simpleFoam");
  EXPECT_SAYS(message, "not converged");
  EXPECT_SAYS(message, "first attempt");
  EXPECT_SAYS(message, "case/firstAttempt/log.simpleFoam");
  EXPECT_TRUE(fs::exists(log));
  EXPECT_TRUE(fs::exists(scratch.path() / "case/firstAttempt/log.simpleFoam"));
}

/// A mesher that leaves a bad face as often as it is told to, and then is the real one.
class BadMesher {
 public:
  explicit BadMesher(const fs::path& folder, int badMeshes)
      : path_(folder.string() + ":" + std::getenv("PATH")) {
    fs::create_directories(folder);
    std::ofstream(folder / "left") << badMeshes;
    std::ofstream(folder / "snappyHexMesh")
        << "#!/bin/sh\nleft=$(cat '" << (folder / "left").string() << "')\n[ \"$left\" -gt 0 ] || exec "
        << "/usr/bin/snappyHexMesh \"$@\"\necho $((left - 1)) > '" << (folder / "left").string()
        << "'\necho 'Finished meshing with 1 illegal faces (concave, zero area or negative cell pyramid "
           "volume)'\n"
        << "echo End\n";
    fs::permissions(folder / "snappyHexMesh", fs::perms::owner_all);
    variable_.emplace("PATH", path_.c_str());
  }

 private:
  std::string path_;
  std::optional<EnvironmentVariable> variable_;
};

TEST(FoamBackendFaults, aMeshThatFailsTwiceIsMadeOfOtherCells) {
  RESTENOSIS_NEEDS_OPENFOAM();
  const TemporaryFolder scratch;
  const BadMesher mesher(scratch / "bin", 2);
  const auto solution =
      FoamBackend(draft()).solve(tube(vesselRadius, vesselLength), vesselConditions(), scratch / "case");
  ASSERT_EQ(solution.remarks.size(), 1u);
  for (const char* words : {"third attempt", "1 illegal faces", "firstAttempt/log.snappyHexMesh",
                            "secondAttempt/log.snappyHexMesh"})
    EXPECT_SAYS(solution.remarks[0], words);
  EXPECT_TRUE(fs::exists(scratch / "case/firstAttempt/log.snappyHexMesh"));
  EXPECT_TRUE(fs::exists(scratch / "case/secondAttempt/log.snappyHexMesh"));
}

TEST(FoamBackendFaults, threeBadMeshesAreAFailure) {
  RESTENOSIS_NEEDS_OPENFOAM();
  const TemporaryFolder scratch;
  const BadMesher mesher(scratch / "bin", 3);
  const auto message = failure(tube(vesselRadius, vesselLength), scratch / "case");
  for (const char* words : {"case/log.snappyHexMesh", "the second attempt", "a first attempt"})
    EXPECT_SAYS(message, words);
}

TEST(FoamBackendFaults, noThirdMeshHasMoreCellsThanAreAllowed) {
  RESTENOSIS_NEEDS_OPENFOAM();
  const TemporaryFolder scratch;
  const BadMesher mesher(scratch / "bin", 2);
  FoamSettings settings = draft();
  const LumenCase shape = measureLumen(tube(vesselRadius, vesselLength), settings);
  settings.maximumCells = 1.1 * expectedCells({shape.volume, shape.wallArea, shape.strutArea}, settings);
  const auto message = failure(tube(vesselRadius, vesselLength), scratch / "case", settings);
  for (const char* words : {"case/log.snappyHexMesh", "a first attempt"}) EXPECT_SAYS(message, words);
  EXPECT_EQ(message.find("the second attempt"), std::string::npos) << "there is no third";
  EXPECT_TRUE(fs::exists(scratch / "case/log.snappyHexMesh"));
}

TEST(FoamBackendFaults, missingProgramNamesItsPackage) {
  const TemporaryFolder scratch;
  const PathOnly nothing(scratch.path());
  const auto message = failure(tube(vesselRadius, vesselLength), scratch.path() / "case");
  EXPECT_SAYS(message, "blockMesh");
  EXPECT_SAYS(message, "apt install openfoam");
}

TEST(FoamBackendFaults, aProgramThatCrashesIsTriedAgainAndOneThatWasEndedFromOutsideIsNot) {
  const TemporaryFolder scratch;
  for (const auto& [signal, words] :
       {std::pair{"9", "blockMesh was killed"}, {"15", "interrupted"}, {"11", "signal 11"}}) {
    const auto programs = scratch.path() / "bin";
    fs::create_directories(programs);
    std::ofstream(programs / "blockMesh") << "#!/bin/sh\nkill -" << signal << " $$\n";
    fs::permissions(programs / "blockMesh", fs::perms::owner_all);
    const PathOnly fake(programs);
    const auto message = failure(tube(vesselRadius, vesselLength), scratch.path() / "case");
    EXPECT_SAYS(message, words);
    EXPECT_EQ(message.find("first attempt") != std::string::npos, std::string(signal) == "11");
  }
}

}  // namespace
}  // namespace restenosis

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>

#include "bridge/flow/foam/DictionaryText.h"
#include "bridge/flow/foam/FoamLog.h"
#include "bridge/flow/foam/FoamTemplate.h"
#include "tests/support/OpenFoamPresent.h"
#include "tests/support/Process.h"

namespace restenosis {
namespace {

namespace fs = std::filesystem;

/// The case template as a user starts it: by its own Allrun, without this program.
class FoamCase : public ::testing::TestWithParam<int> {
 protected:
  TemporaryFolder folder;
};

std::vector<fs::path> entriesOf(const fs::path& at) {
  std::vector<fs::path> names;
  for (const auto& entry : fs::directory_iterator(at)) names.push_back(entry.path().filename());
  std::sort(names.begin(), names.end());
  return names;
}

TEST_P(FoamCase, runsByHandAndIsCleanedUp) {
  RESTENOSIS_NEEDS_OPENFOAM();
  const fs::path at = folder / "case";
  fs::copy(foamTemplate(), at, fs::copy_options::recursive);
  const auto before = entriesOf(at);
  auto numbers = DictionaryText(foamLog::read(at / "system/lumenParameters"));
  numbers.set("ranks", std::to_string(GetParam()));
  std::ofstream(at / "system/lumenParameters") << numbers.text();

  const ProcessEnd end = Process({(at / "Allrun").string()}, folder.path()).wait(std::chrono::minutes(5));
  ASSERT_EQ(end.status, 0) << toString(end);
  EXPECT_EQ(foamLog::read(at / "log.blockMesh").find("Warning"), std::string::npos);
  const auto iterations = foamLog::convergedAfter(foamLog::read(at / "log.simpleFoam"));
  ASSERT_TRUE(iterations.has_value());
  const auto inflow =
      foamLog::lastValue(foamLog::read(at / "postProcessing/inletFlow/0/surfaceFieldValue.dat"));
  ASSERT_TRUE(inflow.has_value());
  EXPECT_NEAR(*inflow / -3.384438e-7, 1.0, 1e-5);  // in m^3/s, as its users expect
  const std::string last = std::to_string(*iterations);
  for (const char* patch : {"wall.vtp", "strut.vtp"})
    EXPECT_TRUE(fs::exists(at / "postProcessing/surface" / last / patch)) << patch;
  for (const auto& file : {fs::path(last) / "U", fs::path(last) / "wallShearStress",
                           fs::path("constant/polyMesh/faces"), fs::path("case.foam")})
    EXPECT_TRUE(fs::exists(at / file)) << file;

  ASSERT_EQ(Process({(at / "Allclean").string()}, folder.path()).wait(std::chrono::minutes(1)).status, 0);
  EXPECT_EQ(entriesOf(at), before);
  fs::remove_all(at / "beats");  // as in the case of a run's steady flow
  EXPECT_EQ(Process({(at / "Allclean").string()}, folder.path()).wait(std::chrono::minutes(1)).status, 0);
}

/// Starts Allrun with programs that do nothing but say these words of checkMesh.
int statusOfAllrun(const TemporaryFolder& folder, const std::string& checkMesh) {
  const fs::path at = folder / "case", programs = folder / "programs";
  fs::copy(foamTemplate(), at, fs::copy_options::recursive);
  fs::create_directories(programs);
  std::ofstream(programs / "words") << "Finished meshing without any errors\n\n"
                                    << checkMesh << "SIMPLE solution converged in 3 iterations\n";
  for (const char* name : {"blockMesh", "snappyHexMesh", "checkMesh", "simpleFoam"}) {
    std::ofstream(programs / name) << "#!/bin/sh\ncat '" << (programs / "words").string() << "'\n";
    fs::permissions(programs / name, fs::perms::owner_all);
  }
  const std::string path = programs.string() + ":" + std::getenv("PATH");
  const int status = Process({(at / "Allrun").string()}, folder.path(), {{"PATH", path}})
                         .wait(std::chrono::minutes(1))
                         .status;
  fs::remove_all(at);
  return status;
}

TEST(FoamCaseByHand, acceptsTheMeshesThatTheProgramAccepts) {
  const TemporaryFolder folder;
  const auto skew = [](const char* skewness, int faces) {
    return fmt::format(" ***Max skewness = {}, {} highly skew faces detected which may impair\n\n", skewness,
                       faces);
  };
  EXPECT_EQ(statusOfAllrun(folder, "Mesh OK.\n"), 0);
  EXPECT_EQ(statusOfAllrun(folder, skew("5.5", 10) + "Failed 1 mesh checks.\n"), 0);
  EXPECT_EQ(statusOfAllrun(folder, skew("5.5", 11) + "Failed 1 mesh checks.\n"), 1);
  EXPECT_EQ(statusOfAllrun(folder, skew("20.5", 3) + "Failed 1 mesh checks.\n"), 1);
  EXPECT_EQ(statusOfAllrun(folder, skew("5.5", 3) + "Failed 2 mesh checks.\n"), 1);
  EXPECT_EQ(statusOfAllrun(folder, ""), 1);
}

INSTANTIATE_TEST_SUITE_P(OnRanks, FoamCase, ::testing::Values(1, 2));

}  // namespace
}  // namespace restenosis

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <optional>

#include "tests/support/Process.h"
#include "tests/support/SyntheticResults.h"
#include "tests/support/TemporaryFolder.h"
#include "tests/support/ViewState.h"

namespace restenosis {
namespace {

namespace fs = std::filesystem;

const char* const noParaView =
    "ParaView's Python is not installed (pvpython, or what RESTENOSIS_PVPYTHON names)";

/// What runs Python with ParaView's modules: RESTENOSIS_PVPYTHON, else pvpython; nothing where there is
/// neither.
std::optional<std::string> pvpython() {
  if (const char* chosen = std::getenv("RESTENOSIS_PVPYTHON")) return chosen;
  if (std::system("command -v pvpython >/dev/null") == 0) return "pvpython";
  return std::nullopt;
}

/// The folder is RESTENOSIS_RESULTS where set (a real run, with its OpenFOAM cases), else made-up results.
TEST(ParaView, LoadsTheSeries) {
  const auto python = pvpython();
  if (!python) GTEST_SKIP() << noParaView;
  TemporaryFolder folder;
  const char* real = std::getenv("RESTENOSIS_RESULTS");
  if (real == nullptr) SyntheticResults().write(folder.path());
  const auto command = fmt::format("'{}' '{}/tests/regression/loadInParaView.py' '{}' > '{}' 2>&1", *python,
                                   RESTENOSIS_SOURCE_DIR, real ? real : folder.path().string(),
                                   (folder / "paraView.log").string());
  EXPECT_EQ(std::system(command.c_str()), 0) << readText(folder / "paraView.log");
}

TEST(ParaView, TheStateHoldsWhatThereIsToShow) {
  if (!picturesPackagesPresent())
    GTEST_SKIP() << "install python3-matplotlib and python3-vtk9 to run this test";
  {
    SCOPED_TRACE("tissue and lumen");
    TemporaryFolder folder;
    SyntheticResults().write(folder.path());
    checkView(folder.path());
  }
  {
    SCOPED_TRACE("one day, before any flow");
    TemporaryFolder folder;
    SyntheticResults results;
    results.frames = 1;
    results.write(folder.path());
    checkView(folder.path());
  }
  for (const char* missing : {"tissue.pvd", "lumen.pvd", "struts.vtp"}) {
    SCOPED_TRACE(missing);
    TemporaryFolder folder;
    SyntheticResults().write(folder.path());
    fs::remove(folder / missing);
    checkView(folder.path());
  }
  {
    SCOPED_TRACE("a lumen that lies as it likes");
    TemporaryFolder folder;
    SyntheticResults().write(folder.path());
    fs::remove(folder / "tissue.pvd");
    writeText(folder / "scene.toml", "[vessel]\nlumenSurface = \"a.stl\"\n");
    checkView(folder.path());
  }
}

TEST(ParaView, TheStateShowsCellsStrutsAndLumen) {
  if (!picturesPackagesPresent())
    GTEST_SKIP() << "install python3-matplotlib and python3-vtk9 to run this test";
  const auto python = pvpython();
  if (!python) GTEST_SKIP() << noParaView;
  for (const bool withTissue : {true, false}) {
    SCOPED_TRACE(withTissue ? "tissue and lumen" : "lumen alone");
    TemporaryFolder folder, pictures;
    SyntheticResults().write(folder.path());
    if (!withTissue) fs::remove(folder / "tissue.pvd");
    checkView(folder.path(), {pictures.path().string(), *python});
  }
}

}  // namespace
}  // namespace restenosis

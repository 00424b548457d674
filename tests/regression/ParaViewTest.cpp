#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/SyntheticResults.h"
#include "tests/support/TemporaryFolder.h"

namespace restenosis {
namespace {

/// The folder is RESTENOSIS_RESULTS where set (a real run, with its OpenFOAM cases), else made-up results.
TEST(ParaView, LoadsTheSeries) {
  if (std::system("command -v pvpython >/dev/null") != 0)
    GTEST_SKIP() << "ParaView (pvpython) is not installed";
  TemporaryFolder folder;
  const char* real = std::getenv("RESTENOSIS_RESULTS");
  if (real == nullptr) SyntheticResults().write(folder.path());
  const auto command =
      fmt::format("pvpython '{}/tests/regression/loadInParaView.py' '{}' > '{}' 2>&1", RESTENOSIS_SOURCE_DIR,
                  real ? real : folder.path().string(), (folder / "paraView.log").string());
  EXPECT_EQ(std::system(command.c_str()), 0) << readText(folder / "paraView.log");
}

}  // namespace
}  // namespace restenosis

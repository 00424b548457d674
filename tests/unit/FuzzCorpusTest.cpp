#include <gtest/gtest.h>

#include <filesystem>

#include "tests/fuzz/FuzzTargets.h"
#include "tests/support/TemporaryFolder.h"

namespace restenosis {
namespace {

/// Every input of a corpus once, so that no fuzzer falls behind the code it is for, and no finding comes
/// back.
TEST(FuzzCorpus, IsReadOrRefusedAsDocumented) {
  const std::filesystem::path corpora = std::filesystem::path(RESTENOSIS_SOURCE_DIR) / "tests/fuzz/corpus";
  for (const FuzzTarget& target : fuzzTargets()) {
    int inputs = 0;
    for (const auto& entry : std::filesystem::directory_iterator(corpora / target.name)) {
      SCOPED_TRACE(entry.path());
      EXPECT_NO_THROW(target.run(readText(entry.path())));
      ++inputs;
    }
    EXPECT_GT(inputs, 0) << target.name;
  }
}

}  // namespace
}  // namespace restenosis

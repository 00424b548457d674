#include <gtest/gtest.h>

#include "tissue/parameters/ParameterProblem.h"

namespace restenosis {
namespace {

TEST(ParameterProblems, KeepsThoseOfChecksThatReadKnownKeysOnly) {
  ParameterProblems problems([](std::string_view key) { return key != "stent.length"; });
  EXPECT_TRUE(problems.known("stent.strutWidth"));
  EXPECT_FALSE(problems.known("stent.length"));
  problems.add({"stent.strutWidth", "too wide"});
  problems.add({"stent.length", "the key itself is unknown"});
  problems.add({"stent.ringCount", "read beside an unknown key", {"stent.strutWidth", "stent.length"}});
  problems.add({"stent.linkCount", "too many", {"stent.ringWaves"}});
  const std::vector<ParameterProblem> all = problems.extract();
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].message, "too wide");
  EXPECT_EQ(all[1].key, "stent.linkCount");
  EXPECT_TRUE(problems.extract().empty());
}

}  // namespace
}  // namespace restenosis

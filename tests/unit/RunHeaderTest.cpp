#include <gtest/gtest.h>

#include "bridge/coupling/RunHeader.h"
#include "bridge/output/Version.h"
#include "bridge/scene/SceneReader.h"
#include "bridge/scene/Units.h"
#include "tests/support/TinyScene.h"

namespace restenosis {
namespace {

std::string header(const std::string& text, const RunPlace& place) {
  return runHeader(SceneReader(Units()).readText(text, "tiny.toml", {}), place);
}

TEST(RunHeader, NamesVersionSceneFlowThreadsAndFolder) {
  EXPECT_EQ(header(std::string(tinyScene), {.threads = 3, .results = "results/tiny"}),
            "restenosisFoam " + std::string(version()) +
                "\ntiny: Tiny\nflow by analytic (draft); threads: 3; results: results/tiny");
}

TEST(RunHeader, NamesTheProcessesOfTheFlowWhereThereAreSeveral) {
  EXPECT_NE(header(tinyFoamScene(), {.ranks = 4, .results = "out"})
                .find("\nflow by foam (reference) on 4 processes; "),
            std::string::npos);
}

TEST(RunHeader, SaysThatThereIsNoFlow) {
  const std::string text = with(tinyScene, "[flow]\nbackend = \"analytic\"\n", "");
  EXPECT_NE(header(text, {}).find("\nno flow; "), std::string::npos);
}

}  // namespace
}  // namespace restenosis

#include "tests/support/WholeProgram.h"

namespace restenosis {
namespace {

using Rest = WholeProgram;

/// Contact inhibition by stress lets the bulk divide. An intact wall must rest all the same.
constexpr std::string_view intactScene = R"([scene]
duration = "28 d"
step = "1 h"

[vessel]
length = "0.3 mm"
lumenDiameter = "1.8 mm"
wallThickness = "0.2 mm"
cellRadius = "15 um"

[injury]
synthetic = "all"

[mechanics]

[cellCycle]

[activation]
entryRate = "4 1/d"
decayTime = "20 d"

[contactInhibition]
law = "stress"

[output]
pictures = false
)";

TEST_F(Rest, AnIntactWallOfActivatedCellsDividesHardlyAndThenNoMore) {
  const std::string matrix = "\n[extracellularMatrix]\nrate = \"2 1/d\"\n";
  for (const auto& [seed, sections] : {std::pair("1", std::string()), {"2", matrix}, {"3", std::string()}}) {
    const std::string out = std::string("out") + seed;
    ASSERT_EXIT_STATUS(run({"run", scene("intact", std::string(intactScene) + sections), "-o", out, "--set",
                            std::string("scene.seed=") + seed}),
                       0);
    const CsvColumns days(folder.path() / out / "timeSeries.csv");
    const auto& divisions = days.values.at("divisions");
    EXPECT_LE(days.last("divisions"), 0.01 * days.last("synthetic")) << out;
    EXPECT_EQ(divisions.back(), divisions[divisions.size() / 2]) << out << ": none in the second half";
    EXPECT_GT(days.last("synthetic"), 1000) << out;
  }
}

TEST_F(Rest, NothingGrowsWithoutStentAndInjury) {
  ASSERT_EXIT_STATUS(run({"run", scene("intact", intactScene), "-o", "out", "--set",
                          "injury.synthetic=nearInjury", "--set", "scene.duration=10 d"}),
                     0);
  EXPECT_EQ(summary("out")["final"]["synthetic"], 0);
  EXPECT_EQ(summary("out")["final"]["divisions"], 0);
}

}  // namespace
}  // namespace restenosis

// Biology at the ends of what a scene may say: the run ends well all the same.

#include "tests/support/WholeProgram.h"

namespace restenosis {
namespace {

class GrowthExtremes : public WholeProgram {
 protected:
  /// The summary of the tiny scene with other values. The run must end well: where it does not, null.
  nlohmann::json grow(const std::vector<std::string>& overrides) const {
    std::vector<std::string> arguments = {"run", scene("tiny", tinyScene), "-o", "out"};
    for (const auto& value : overrides) arguments.insert(arguments.end(), {"--set", value});
    const ProcessEnd end = run(arguments);
    EXPECT_EXIT_STATUS(end, 0);
    if (end.status != 0) return {};
    // JSON has no NaN: a value that is none is written as null, as is what only a flow tells.
    const auto json = summary("out");
    const bool flowKnown = json["flow"]["solvesDone"] > 0;
    for (const auto& [key, value] : json["final"].items()) {
      if (key.starts_with("crossCheck")) continue;  // the flow is not cross-checked
      const bool ofFlow = key.starts_with("wss") || key.starts_with("nitric") ||
                          key.starts_with("lumenMovement") || key.starts_with("flowRate") ||
                          key.starts_with("pressureDrop");
      const bool ofLamina =
          key.starts_with("intima") || key.starts_with("media") || key.starts_with("relative");
      EXPECT_EQ(value.is_null(), (ofFlow && !flowKnown) || ofLamina) << key;  // the IEL is removed
    }
    return json;
  }
};

const std::string noFlow = "flow.backend=none";

TEST_F(GrowthExtremes, AStepOfADay) {
  const auto json = grow({"scene.step=24 h", "scene.duration=4 d"});
  ASSERT_FALSE(json.is_null());
  EXPECT_GT(json["final"]["divisions"], 0);
}

TEST_F(GrowthExtremes, PhasesOfNoLength) {
  const auto json = grow({"cellCycle.g1Mean=0 h", "cellCycle.g1Spread=0 h", "cellCycle.sg2mDuration=0 h",
                          noFlow, "scene.duration=8 h"});
  ASSERT_FALSE(json.is_null());
  EXPECT_GT(json["final"]["divisions"], 0);
}

TEST_F(GrowthExtremes, AllCellsDividingAtOnce) {
  const auto json = grow({"cellCycle.g1Spread=0 h", "contactInhibition.law=neighbourCount",
                          "contactInhibition.countThreshold=1000000", noFlow, "scene.duration=34 h"});
  ASSERT_FALSE(json.is_null());
  const int synthetic = json["final"]["synthetic"], divisions = json["final"]["divisions"];
  EXPECT_GT(divisions, 0);
  EXPECT_EQ(synthetic, 2 * divisions);
}

TEST_F(GrowthExtremes, ThresholdsThatHoldEveryCell) {
  for (const auto& threshold :
       {std::vector<std::string>{"contactInhibition.exposureThreshold=1"},
        {"contactInhibition.law=neighbourCount", "contactInhibition.countThreshold=0"}}) {
    auto overrides = threshold;
    overrides.insert(overrides.end(), {noFlow, "scene.duration=2 d"});
    const auto json = grow(overrides);
    ASSERT_FALSE(json.is_null());
    EXPECT_EQ(json["final"]["divisions"], 0) << threshold[0];
  }
}

TEST_F(GrowthExtremes, AThresholdThatHoldsNoExposedCell) {
  const auto none = grow({"contactInhibition.exposureThreshold=0", noFlow, "scene.duration=2 d"});
  const auto byDefault = grow({noFlow, "scene.duration=2 d"});
  ASSERT_FALSE(none.is_null());
  ASSERT_FALSE(byDefault.is_null());
  EXPECT_GT(byDefault["final"]["divisions"], 0);
  EXPECT_GT(none["final"]["divisions"], byDefault["final"]["divisions"]);
}

TEST_F(GrowthExtremes, NitricOxideThatArrestsAtOnceAndNever) {
  const auto atOnce = grow({"endothelium.nitricOxideThreshold=0.000001 nmol/mm^3"});
  const auto never = grow({"endothelium.nitricOxideThreshold=1000000 nmol/mm^3"});
  ASSERT_FALSE(atOnce.is_null());
  ASSERT_FALSE(never.is_null());
  EXPECT_LT(atOnce["final"]["divisions"], never["final"]["divisions"]);
}

/// A vessel of the given agents, one a row of x, y, z, radius.
class FewAgents : public GrowthExtremes, public testing::WithParamInterface<int> {};

TEST_P(FewAgents, AreATissueToo) {
  std::string table = "x,y,z,radius,kind\n";
  for (int k = 0; k < GetParam(); ++k)
    table += std::to_string(300 + 20 * k) + ",0," + std::to_string(100 + 3 * k) + ",18,smc\n";
  writeText(folder / "agents.csv", table);
  const std::string text = R"([scene]
duration = "3 d"
step = "1 h"
[vessel]
length = "0.24 mm"
lumenDiameter = "0.4 mm"
wallThickness = "0.12 mm"
agents = "agents.csv"
fixedEnds = 0
[injury]
synthetic = "all"
[mechanics]
[cellCycle]
[output]
pictures = false
)";
  const ProcessEnd end = run({"run", scene("few", text), "-o", "out"});
  EXPECT_EXIT_STATUS(end, 0);
  EXPECT_NE((end.out + end.err).find("loading the wall"), std::string::npos) << end.out << end.err;
  if (end.status == 0) {
    EXPECT_GT(summary("out")["final"]["divisions"], 0);
  }
}

INSTANTIATE_TEST_SUITE_P(Count, FewAgents, testing::Values(1, 10));

TEST_F(GrowthExtremes, ActivationThatIsNothingAndHuge) {
  const auto none = grow({"activation.entryRate=0 1/d", noFlow, "scene.duration=2 d"});
  const auto over = grow({"activation.decayTime=1e-9 d", noFlow, "scene.duration=2 d"});
  const auto atOnce =
      grow({"activation.entryRate=10000 1/d", "activation.decayTime=1e6 d", noFlow, "scene.duration=2 d"});
  const auto without = grow({noFlow, "scene.duration=2 d"});
  for (const auto* json : {&none, &over, &atOnce, &without}) ASSERT_FALSE(json->is_null());
  EXPECT_EQ(none["final"]["divisions"], 0);
  EXPECT_EQ(over["final"]["divisions"], 0);
  const double expected = without["final"]["divisions"], divisions = atOnce["final"]["divisions"];
  EXPECT_NEAR(divisions, expected, 0.05 * expected) << "as if all left rest at once";
}

TEST_F(GrowthExtremes, StretchThatActivatesAllAndNone) {
  const auto spared = "injury.synthetic=nearInjury";
  const auto all =
      grow({"activation.stretchOnset=0", "activation.stretchFull=0", spared, noFlow, "scene.duration=2 h"});
  const auto none = grow(
      {"activation.stretchOnset=100", "activation.stretchFull=100", spared, noFlow, "scene.duration=2 h"});
  ASSERT_FALSE(all.is_null());
  ASSERT_FALSE(none.is_null());
  EXPECT_GT(all["injury"]["syntheticCellsByStretch"], 0);
  EXPECT_EQ(none["injury"]["syntheticCellsByStretch"], 0);
}

TEST_F(GrowthExtremes, MatrixThatIsNothingAndHuge) {
  const auto thickness = [&](const std::string& rate, const std::string& largest) {
    const auto json = grow({"extracellularMatrix.rate=" + rate, "extracellularMatrix.largestShare=" + largest,
                            "contactInhibition.law=stress", noFlow, "scene.duration=1 d"});
    return json.is_null() ? -1 : json["final"]["neointimaThickness_um"].get<double>();
  };
  const double none = thickness("0 1/d", "0.6");
  EXPECT_EQ(thickness("10000 1/d", "0"), none) << "a share of nothing";
  EXPECT_NEAR(thickness("1e-9 1/d", "0.6"), none, 0.01);
  EXPECT_GT(thickness("10000 1/d", "0.95"), none + 1);
}

TEST_F(GrowthExtremes, PressureThatInhibitsAllAndNone) {
  const auto divisions = [&](const std::string& threshold) {
    const auto json = grow({"contactInhibition.law=stress", "contactInhibition.stressThreshold=" + threshold,
                            noFlow, "scene.duration=2 d"});
    return json.is_null() ? -1 : static_cast<int>(json["final"]["divisions"]);
  };
  const int least = divisions("0 kPa"), most = divisions("1000000 kPa");
  EXPECT_GE(least, 0);
  EXPECT_GT(most, least);
}

TEST_F(GrowthExtremes, EndotheliumThatNeverMaturesAndNitricOxideThatReachesAll) {
  const auto plain = grow({});
  const auto immature = grow({"endothelium.maturationTime=1000000 d"});
  const auto mature = grow({"endothelium.maturationTime=1e-9 d"});
  const auto reaching = grow({"endothelium.nitricOxideReach=10000 um"});
  const auto tiny = grow({"endothelium.nitricOxideReach=1e-9 um"});
  for (const auto* json : {&plain, &immature, &mature, &reaching, &tiny}) ASSERT_FALSE(json->is_null());
  const auto divisions = [](const nlohmann::json& json) { return json["final"]["divisions"].get<int>(); };
  EXPECT_GT(divisions(immature), divisions(plain));
  EXPECT_EQ(divisions(mature), divisions(plain));
  EXPECT_EQ(divisions(tiny), divisions(plain));
  EXPECT_LT(divisions(reaching), divisions(plain));
}

}  // namespace
}  // namespace restenosis

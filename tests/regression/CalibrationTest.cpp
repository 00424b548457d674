#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/support/Process.h"
#include "tests/support/TinyScene.h"

namespace restenosis {
namespace {

namespace fs = std::filesystem;

const std::string script = RESTENOSIS_SOURCE_DIR "/studies/calibration/calibrate";

/// In place of the program: areas that are powers of the parameters, a little different for each seed, and a
/// share of matrix of its own. It notes each run, and its first run of all is a failure where `fails` exists.
const char* const powers = R"(#!/usr/bin/python3
import pathlib, sys
here = pathlib.Path(__file__).parent
folder = pathlib.Path(sys.argv[sys.argv.index("-o") + 1])
values = dict(word.split("=", 1) for option, word in zip(sys.argv, sys.argv[1:]) if option == "--set")
rate, decay, matrix = (float(values[key].split()[0]) for key in
                       ("activation.entryRate", "activation.decayTime", "extracellularMatrix.rate"))
if (here / "fails").exists():
    (here / "fails").unlink()
    sys.exit("no flow today")
with open(here / "runs", "a") as runs:
    runs.write(f"{rate} {decay} {matrix} {values['scene.seed']}\n")
bias = 1 + 0.02 * (float(values["scene.seed"]) - 2)
folder.mkdir(parents=True)
rows = [(day, bias * 0.1 * rate**0.9 * decay**(day / 30) / 3, 0.3 * matrix**0.5) for day in (0, 14, 28, 60)]
(folder / "timeSeries.csv").write_text("day,relativeIntimaArea,intimaMatrixShare\n"
                                       + "".join(f"{day},{area},{share}\n" for day, area, share in rows))
(folder / "summary.json").write_text('{"status": "finished"}')
)";

class Calibration : public ::testing::Test {
 protected:
  void SetUp() override {
    const ProcessEnd end =
        Process({"/usr/bin/python3", "-c", "import scipy"}, folder.path()).wait(std::chrono::minutes(1));
    if (end.status != 0) GTEST_SKIP() << "python3-scipy is not installed";
    writeText(folder / "powers", powers);
    fs::permissions(folder / "powers", fs::perms::owner_all);
  }
  ProcessEnd calibrate(const fs::path& study, const std::string& within = "0.05") const {
    return Process({script, study.string(), "-o", (folder / "fit").string(), "--program",
                    (folder / "powers").string(), "--within", within},
                   folder.path())
        .wait(std::chrono::minutes(2));
  }
  double found(const std::string& key) const {
    return std::stod(nlohmann::json::parse(readText(folder / "fit/found.json"))[key].get<std::string>());
  }
  std::size_t runs() const {
    const std::string text = readText(folder / "runs");
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  }
  TemporaryFolder folder;
  const fs::path study = RESTENOSIS_SOURCE_DIR "/studies/calibration/porcineInjury2.toml";
};

TEST_F(Calibration, FindsTheParametersOfAKnownLaw) {
  const ProcessEnd end = calibrate(study);
  ASSERT_EQ(end.status, 0) << toString(end);
  const double rate = found("activation.entryRate"), decay = found("activation.decayTime");
  EXPECT_NEAR(0.1 / 3 * std::pow(rate, 0.9) * std::pow(decay, 14.0 / 30), 0.20, 0.005);
  EXPECT_NEAR(0.1 / 3 * std::pow(rate, 0.9) * std::pow(decay, 28.0 / 30), 0.42, 0.01);
  EXPECT_NEAR(found("extracellularMatrix.rate"), std::pow(0.5 / 0.3, 2), 0.1);
}

TEST_F(Calibration, EndsWithATrialThatMeetsEveryTarget) {
  ASSERT_EQ(calibrate(study, "100").status, 0);
  EXPECT_EQ(runs(), 3u) << "the start, by three seeds, and no derivatives";
}

TEST_F(Calibration, MakesNoRunTwice) {
  ASSERT_EQ(calibrate(study).status, 0);
  const std::size_t first = runs();
  const std::string result = readText(folder / "fit/found.json");
  ASSERT_EQ(calibrate(study).status, 0);
  EXPECT_EQ(runs(), first);
  EXPECT_EQ(readText(folder / "fit/found.json"), result);
}

TEST_F(Calibration, GoesOnAfterARunThatFailed) {
  writeText(folder / "fails", "");
  const ProcessEnd failed = calibrate(study);
  EXPECT_EQ(failed.status, 1);
  EXPECT_NE(failed.err.find("a run failed: see "), std::string::npos) << toString(failed);
  EXPECT_EQ(calibrate(study).status, 0);
}

TEST_F(Calibration, NamesWhatIsWrongInAStudy) {
  writeText(folder / "few.toml", with(readText(study), "[[target]]", "[[other]]"));
  const ProcessEnd end = calibrate(folder / "few.toml");
  EXPECT_EQ(end.status, 2);
  EXPECT_NE(end.err.find("few.toml"), std::string::npos) << toString(end);
  EXPECT_FALSE(fs::exists(folder / "fit"));
}

}  // namespace
}  // namespace restenosis

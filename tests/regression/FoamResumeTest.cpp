#include <fmt/format.h>

#include <thread>

#include "tests/support/OpenFoamPresent.h"
#include "tests/support/WholeProgram.h"

namespace restenosis {
namespace {

using namespace std::chrono_literals;

/// Every solve starts from the case of the one before, so a resumed run must find the one that its checkpoint
/// knows, untouched, and not the later ones of the run that was killed.
class FoamResume : public WholeProgram, public ::testing::WithParamInterface<const char*> {
 protected:
  /// Solves at 72, 74, 76 and 78 hours; checkpoints every four.
  std::string tiny() const {
    const std::string text = with(with(tinyFoamScene(), "\"4 d\"", "\"78 h\""), "\"6 h\"", "\"4 h\"");
    return scene("tiny", with(text, "lumenTolerance = \"5 um\"",
                              fmt::format("lumenTolerance = \"1 um\"\nremesh = \"{}\"", GetParam())));
  }
  /// A file that the next solve reads of the case of 74 hours; U and p lie in its last iteration.
  std::filesystem::path startFile(const std::string& name) const {
    const auto flow = folder / "out/flow/3.08333";
    if (name.size() > 1) return flow / name;
    int last = 0;
    for (const auto& entry : std::filesystem::directory_iterator(flow))
      last = std::max(last, std::atoi(entry.path().filename().c_str()));
    return flow / std::to_string(last) / name;
  }
  static std::string flipped(std::string text) {
    text[text.size() / 2] = static_cast<char>(text[text.size() / 2] ^ 4);
    return text;
  }
  static std::string zeroed(std::string text) {
    const std::size_t size = std::min<std::size_t>(4096, text.size() / 2);
    return text.replace(text.size() - size, size, size, '\0');
  }
  void expectRefusedFor(const std::string& text, const std::string& why) const {
    const ProcessEnd end = run({"run", text, "-o", "out", "--resume"});
    EXPECT_EXIT_STATUS(end, 2);
    EXPECT_NE(end.err.find("goes on from the flow in out/flow/3.08333, where "), std::string::npos)
        << end.err;
    EXPECT_NE(end.err.find(why), std::string::npos) << end.err;
    EXPECT_NE(end.err.find("--flow-from-rest"), std::string::npos) << end.err;
  }
};

TEST_P(FoamResume, aKilledRunStartsFromTheCaseThatItsCheckpointKnows) {
  RESTENOSIS_NEEDS_OPENFOAM();
  const std::string text = tiny();
  ASSERT_EXIT_STATUS(run({"run", text, "-o", "reference"}), 0);
  const auto flow = summary("reference")["flow"];
  ASSERT_GE(flow["solvesDone"], 4);
  if (GetParam() == std::string("onDemand")) {
    EXPECT_GE(flow["meshesMoved"], 1);
    EXPECT_EQ(flow["remeshedBecause"]["there was no former mesh"], 1);
  } else {
    EXPECT_EQ(flow["meshesMoved"], 0);
    EXPECT_TRUE(flow["remeshedBecause"].empty());
  }

  // Killed while it solves at 76 hours: the checkpoint is of 76 hours and knows the flow of 74
  Process process(command({"run", text, "-o", "out"}), folder.path());
  while (process.running() && !exists("out/flow/3.16667/system")) std::this_thread::sleep_for(2ms);
  process.send(SIGKILL);
  EXPECT_EQ(process.wait(patience).signal, SIGKILL);
  EXPECT_TRUE(exists("out/flow/3.08333/case.foam"));

  std::filesystem::rename(folder / "out/flow", folder / "out/elsewhere");
  const ProcessEnd lost = run({"run", text, "-o", "out", "--resume"});
  EXPECT_EXIT_STATUS(lost, 2);
  EXPECT_NE(lost.err.find("goes on from the flow in out/flow/3.08333"), std::string::npos) << lost.err;
  std::filesystem::rename(folder / "out/elsewhere", folder / "out/flow");
  for (const char* file : {"constant/polyMesh/points", "constant/polyMesh/boundary", "U", "p"}) {
    const auto damaged = startFile(file);
    const std::string intact = readText(damaged);
    for (const std::string& content : {flipped(intact), zeroed(intact), std::string()}) {
      SCOPED_TRACE(damaged.string() + ": " + std::to_string(content.size()));
      writeText(damaged, content);
      expectRefusedFor(text, damaged.filename().string() + " has been changed");
    }
    std::filesystem::remove(damaged);
    expectRefusedFor(text, damaged.filename().string());
    writeText(damaged, intact);
  }
  std::filesystem::create_directory(folder / "out/flow/3.08333/99999");
  expectRefusedFor(text, "99999/U");
  std::filesystem::remove(folder / "out/flow/3.08333/99999");

  // Lost, but not the run with it
  std::filesystem::copy(folder / "out", folder / "lost", std::filesystem::copy_options::recursive);
  std::filesystem::remove(folder / "lost/flow/3.08333/constant/polyMesh/owner");
  ASSERT_EXIT_STATUS(run({"run", text, "-o", "lost", "--resume", "--flow-from-rest"}), 0);
  EXPECT_EQ(summary("lost")["sceneFingerprint"], "");
  EXPECT_EQ(summary("lost")["flow"]["solvesDone"], flow["solvesDone"]);
  int said = 0;
  const auto after = summary("lost");
  for (const std::string remark : after["remarks"])
    said += remark.starts_with("the flow goes on from rest on a new mesh") &&
            remark.find("owner") != std::string::npos;
  EXPECT_EQ(said, 1) << after["remarks"];

  ASSERT_EXIT_STATUS(run({"run", text, "-o", "out", "--resume"}), 0);
  EXPECT_EQ(digest("out"), digest("reference"));
  EXPECT_EQ(summary("out")["flow"], flow);
}

TEST_P(FoamResume, otherSettingsNeedNoFormerCase) {
  RESTENOSIS_NEEDS_OPENFOAM();
  const std::string text = tiny();
  ASSERT_EXIT_STATUS(run({"run", text, "-o", "out", "--set", "scene.duration=76 h"}), 0);
  const int solved = summary("out")["flow"]["solvesDone"];
  std::filesystem::remove_all(folder / "out/flow");
  ASSERT_EXIT_STATUS(run({"run", text, "-o", "out", "--resume", "--set", "foam.snapIterations=2"}), 0);
  const auto after = summary("out");
  ASSERT_EQ(after["flow"]["solvesDone"], solved + 1);
  int said = 0;
  for (const std::string remark : after["remarks"])
    said += remark.ends_with("solved with other settings than before: foam.snapIterations = 2 (before: 5)");
  EXPECT_EQ(said, 1) << after["remarks"];
  if (GetParam() == std::string("onDemand")) {
    EXPECT_EQ(after["flow"]["remeshedBecause"]["there was no former mesh"], 2);
  }
}

INSTANTIATE_TEST_SUITE_P(remesh, FoamResume, ::testing::Values("always", "onDemand"),
                         [](const auto& test) { return std::string(test.param); });

}  // namespace
}  // namespace restenosis

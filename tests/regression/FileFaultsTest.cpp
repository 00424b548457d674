#include "tests/support/FileFaults.h"

namespace restenosis {
namespace {

namespace fs = std::filesystem;

/// A part of them; all are met by the tests `long`.
class AnyFault : public FileFaults, public ::testing::WithParamInterface<const char*> {};

TEST_P(AnyFault, LeavesARunThatEndsAsTheWholeOne) {
  scene("short", shortScene);
  const std::string kind = GetParam();
  expectEveryFaultMended(kind, kind == "torn" ? 2 : 5);
}

INSTANTIATE_TEST_SUITE_P(kinds, AnyFault, ::testing::Values("fail", "torn", "kill"),
                         [](const auto& test) { return std::string(test.param); });

TEST_F(FileFaults, WritesThatTakeOnlyHalfAreGoneOnWith) {
  scene("short", shortScene);
  ASSERT_EXIT_STATUS(run(start("whole", false)), 0);
  ASSERT_EXIT_STATUS(run(start("halved", false), faulty("halved", "short", 0)), 0);
  EXPECT_EQ(differing(lasting("halved"), lasting("whole")), std::set<std::string>());
  EXPECT_GT(operations().size(), 200U);
}

/// A finished run in a folder that holds another in `previous/`, and the user's files in both, when a third
/// is started.
class FaultsMovingAside : public FileFaults, public ::testing::WithParamInterface<const char*> {
 protected:
  void twoRuns() const {
    for (const char* title : {"first", "second"}) {
      scene("short", with(with(shortScene, "Short", title), "6 h\"\nstep", "2 h\"\nstep"));
      ASSERT_EXIT_STATUS(run(start("two", false)), 0);
    }
    fs::create_directories(folder / "two/previous/flow/mine");
    for (const char* users : {"notes", "previous/notes", "previous/flow/mine/U"})
      writeText(folder / "two" / users, "mine");
  }
};

TEST_P(FaultsMovingAside, LoseNoFinishedRun) {
  const std::string kind = GetParam();
  twoRuns();
  const auto second = contents("two");
  // What was at the top is to be in previous/
  const auto expectMoved = [&] {
    std::set<std::string> wrong;
    for (const auto& [path, text] : second) {
      const fs::path name = fs::path(path).lexically_relative(folder / "two");
      const bool users = text == "mine";
      const bool replaced = *name.begin() == "previous" && !users;
      const fs::path now = folder / "out" / (users ? name : "previous" / name);
      if (!replaced && readText(now) != text) wrong.insert(name.string());
    }
    EXPECT_EQ(wrong, std::set<std::string>());
    for (const char* left : {"out/previous.partial", "out/previous.replaced"}) EXPECT_FALSE(exists(left));
  };
  const auto copied = [&] {
    fs::remove_all(folder / "out");
    fs::copy(folder / "two", folder / "out", fs::copy_options::recursive);
  };
  scene("short", with(shortScene, "Short", "third"));
  copied();
  ASSERT_EXIT_STATUS(run(start("out", false), faulty("out", "kill", 500)), 0);
  expectMoved();
  const auto all = operations();
  const auto begun = std::ranges::find_if(
      all, [](const std::string& operation) { return operation.ends_with("out/scene.toml.partial"); });
  ASSERT_NE(begun, all.end());
  const auto count = static_cast<std::size_t>(begun - all.begin());
  ASSERT_GT(count, 20U);
  for (std::size_t n = 1; n <= count; ++n) {
    SCOPED_TRACE(std::to_string(n) + ": " + all[n - 1]);
    copied();
    const ProcessEnd end = run(start("out", false), faulty("out", kind, n));
    if (kind == "kill") {
      EXPECT_EQ(end.signal, SIGKILL) << toString(end);
    } else {
      EXPECT_EXIT_STATUS(end, end.err.find("choose another folder") != std::string::npos ? 2 : 1);
      EXPECT_TRUE(names(end.err, all[n - 1])) << toString(end);
    }
    ASSERT_EXIT_STATUS(run(start("out", false)), 0);
    expectMoved();
    EXPECT_EQ(summary("out")["title"], "third");
  }
}

INSTANTIATE_TEST_SUITE_P(kinds, FaultsMovingAside, ::testing::Values("fail", "kill"),
                         [](const auto& test) { return std::string(test.param); });

}  // namespace
}  // namespace restenosis

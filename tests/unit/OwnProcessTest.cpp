#include <gtest/gtest.h>

#include <csignal>
#include <stdexcept>

#include "bridge/system/OwnProcess.h"
#include "tests/support/ExpectSays.h"

namespace restenosis {
namespace {

std::string endOf(const std::function<std::string()>& make) {
  try {
    inOwnProcess(make);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "made";
}

TEST(OwnProcess, ReturnsWhatWasMade) {
  EXPECT_EQ(inOwnProcess([] { return std::string(); }), "");
  const std::string large(5 << 20, 'x');
  int calls = 0;
  EXPECT_EQ(inOwnProcess([&] {
              ++calls;
              return large;
            }),
            large);
  EXPECT_EQ(calls, 0) << "this process stays as it was";
}

TEST(OwnProcess, PassesOnWhatWasThrown) {
  EXPECT_EQ(endOf([]() -> std::string { throw std::runtime_error("line 3 is wrong"); }), "line 3 is wrong");
}

TEST(OwnProcess, OutlivesACrash) {
  EXPECT_SAYS(endOf([] {
                std::raise(SIGKILL);
                return std::string("not said");
              }),
              "crashed");
}

}  // namespace
}  // namespace restenosis

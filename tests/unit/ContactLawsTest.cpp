#include <gtest/gtest.h>

#include "tissue/forces/ContactLaws.h"

namespace restenosis {
namespace {

TEST(ContactLaws, FindsEveryLawByItsName) {
  EXPECT_EQ(contactLawNames(), (std::vector<std::string_view>{"hertz", "hertzNeoHookean"}));
  for (const auto name : contactLawNames()) EXPECT_EQ(contactLaw(name).name, name);
}

TEST(ContactLaws, SaysWhichNamesThereAre) {
  try {
    contactLaw("linear");
    FAIL();
  } catch (const std::invalid_argument& e) {
    EXPECT_STREQ(e.what(), "unknown contact law 'linear'; known: hertz, hertzNeoHookean");
  }
}

}  // namespace
}  // namespace restenosis

#include <gtest/gtest.h>

#include <array>

#include "tissue/parameters/NamedTable.h"

namespace restenosis {
namespace {

constexpr std::array numbers{Named<int>{"one", 1}, Named<int>{"two", 2}};

TEST(NamedTable, FindsEntriesByName) {
  EXPECT_EQ(findNamed(numbers, "number", "one").value, 1);
  EXPECT_EQ(findNamed(numbers, "number", "two").value, 2);
  EXPECT_EQ(namesOf(numbers), (std::vector<std::string_view>{"one", "two"}));
}

TEST(NamedTable, AnUnknownNameIsRefusedWithAllNames) {
  const auto refusal = [](auto... list) -> std::string {
    try {
      findNamed(numbers, "number", "One", list...);
      return "found";
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
  };
  EXPECT_EQ(refusal(), "unknown number 'One'; known: one, two");
  EXPECT_EQ(refusal("allowed are"), "unknown number 'One'; allowed are one, two");
}

}  // namespace
}  // namespace restenosis

#include <gtest/gtest.h>

#include <stdexcept>

#include "bridge/flow/foam/DictionaryText.h"

namespace restenosis {
namespace {

TEST(DictionaryText, valueChangesCommentsStay) {
  DictionaryText text("// flow\nflowRate            338;   // [mm^3/s]\nflow  2;\npoint (0 0 1);\n");
  EXPECT_EQ(text.get("flow"), "2");
  text.set("flowRate", 0.1);
  text.set("point", "(1 2 3)");
  EXPECT_EQ(text.text(), "// flow\nflowRate            0.1;   // [mm^3/s]\nflow  2;\npoint (1 2 3);\n");
}

TEST(DictionaryText, unknownEntryIsNamed) {
  DictionaryText text("a 1;\n");
  EXPECT_THROW(text.set("ab", 1.0), std::invalid_argument);
  EXPECT_THROW(text.get("b"), std::invalid_argument);
}

}  // namespace
}  // namespace restenosis

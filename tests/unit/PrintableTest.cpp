#include <gtest/gtest.h>

#include "tissue/parameters/Printable.h"
#include "tissue/parameters/Shown.h"

namespace restenosis {
namespace {

TEST(Printable, LeavesWhatIsSeen) {
  for (const char* text : {"", "a b ~", "Gefäß", "µm", "血管", "🫀", "l'artère"})
    EXPECT_EQ(printable(text), text);
}

TEST(Printable, EscapesWhatATerminalObeys) {
  EXPECT_EQ(printable("\x1b[2Jx\r\x7f\b"), "\\x1b[2Jx\\x0d\\x7f\\x08");
  EXPECT_EQ(printable(std::string_view("a\0b", 3)), "a\\x00b");
  EXPECT_EQ(printable("\u009b31m"), "\\u009b31m") << "the same begin of a command in one character";
  EXPECT_EQ(printable("a\nb\tc"), "a\\nb\\tc");
  EXPECT_EQ(printable("a\nb\tc\r", true), "a\nb\tc\\x0d");
}

TEST(Printable, EscapesWhatIsNotSeen) {
  EXPECT_EQ(printable("a\u202eb"), "a\\u202eb") << "right to left from here";
  EXPECT_EQ(printable("\u2066x\u2069"), "\\u2066x\\u2069");
  EXPECT_EQ(printable("a\u200bb\u00adc\ufeff"), "a\\u200bb\\u00adc\\ufeff");
  EXPECT_EQ(printable("\u2028\U000E0041"), "\\u2028\\U000e0041");
}

TEST(Printable, EscapesBytesThatAreNoUtf8) {
  EXPECT_EQ(printable("a\xff\xc3"), "a\\xff\\xc3");
  EXPECT_EQ(printable("\xc3(\x80"), "\\xc3(\\x80");
  EXPECT_EQ(printable("\xc0\xaf"), "\\xc0\\xaf") << "longer than need be";
  EXPECT_EQ(printable("\xed\xa0\x80"), "\\xed\\xa0\\x80") << "half of a pair of UTF-16";
  EXPECT_EQ(printable("\xf4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80") << "past the last character";
  EXPECT_EQ(printable("\xe2\x82"), "\\xe2\\x82") << "cut off";
}

TEST(Printable, ShownIsCutBetweenCharacters) {
  EXPECT_EQ(shown("1,5\x1b"), "'1,5\\x1b'");
  EXPECT_EQ(shown(std::string(40, 'a')), "'" + std::string(40, 'a') + "'");
  EXPECT_EQ(shown(std::string(41, 'a')), "'" + std::string(40, 'a') + "...'");
  EXPECT_EQ(shown(std::string(39, 'a') + "µm"), "'" + std::string(39, 'a') + "µ...'");
}

}  // namespace
}  // namespace restenosis

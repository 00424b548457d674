#include <gtest/gtest.h>

#include "bridge/scene/SceneDocument.h"
#include "bridge/scene/TomlDepth.h"

namespace restenosis {
namespace {

std::string repeated(std::string_view piece, std::size_t times) {
  std::string text;
  for (std::size_t k = 0; k < times; ++k) text += piece;
  return text;
}

TEST(TomlDepth, IsThatOfDottedNames) {
  const std::string deep = "a" + repeated(".a", mostNameParts),
                    most = "a" + repeated(".a", mostNameParts - 1);
  EXPECT_EQ(lineOfDeepName(""), 0);
  EXPECT_EQ(lineOfDeepName("[" + most + "]\n" + most + " = 1\n"), 0);
  EXPECT_EQ(lineOfDeepName("[a]\n\n[" + deep + "]\n"), 3);
  EXPECT_EQ(lineOfDeepName("[a]\n" + deep + " = 1"), 2);
  EXPECT_EQ(lineOfDeepName("[a]\nx = {" + deep + " = 1}"), 2);
  EXPECT_EQ(lineOfDeepName("'a'" + repeated(" . \"a]\"", mostNameParts)), 1);
}

TEST(TomlDepth, TakesNoTextForAName) {
  const std::string points = repeated(".", 100);
  for (const std::string& text :
       {"# " + points, "x = \"\\\"" + points + "\"", "x = '\\" + points + "'",
        "x = ''" + std::string(" # ") + points,
        "x = \"\"\"\n" + points + "\\\"\"\"" + points + "\"\"\"\"\"\n", "x = '''\n" + points + "''''\n",
        "x = [1.5, " + repeated("1.5, ", 100) + "]"}) {
    EXPECT_EQ(lineOfDeepName(text), 0) << text;
    EXPECT_EQ(lineOfDeepName(text + "\n" + repeated("a.", 100)),
              2 + static_cast<int>(std::count(text.begin(), text.end(), '\n')))
        << text;
  }
}

/// As many as crashed the parser, in every kind of place that a name can have.
TEST(TomlDepth, IsBoundedBeforeTheParserSeesIt) {
  constexpr std::size_t many = 175'000;
  const std::string deep = "a" + repeated(".a", many);
  for (const std::string& text :
       {"[" + deep + "]\n", "[[" + deep + "]]\n", deep + " = 1\n", "x = {" + deep + " = 1}\n",
        "x = " + repeated("[", many), "x = " + repeated("{a=", many), repeated("a.\"b\"=[\n{", many)}) {
    std::vector<Diagnostic> diagnostics;
    const SceneDocument document(text, "x.toml", diagnostics);
    EXPECT_TRUE(document.broken()) << text.substr(0, 20);
    ASSERT_EQ(diagnostics.size(), 1u) << text.substr(0, 20);
    EXPECT_GE(diagnostics[0].line, 1);
  }
  std::vector<Diagnostic> diagnostics;
  SceneDocument document("[a]\n", "x.toml", diagnostics);
  document.apply({"a.b={" + deep + " = 1}"}, diagnostics);
  document.apply({"a.c=" + repeated("[", many)}, diagnostics);
  EXPECT_TRUE(diagnostics.empty());
}

TEST(TomlDepth, OfADottedNameIsSaidWithItsLine) {
  std::vector<Diagnostic> diagnostics;
  const SceneDocument document("[a]\nb = 1\n[" + repeated("a.", 1000) + "a]\n", "x.toml", diagnostics);
  ASSERT_EQ(diagnostics.size(), 1u);
  EXPECT_EQ(toString(diagnostics[0]),
            "x.toml:3: a name of more than 16 parts with points between them; keys are named by themselves, "
            "below a "
            "header such as [vessel]");
}

}  // namespace
}  // namespace restenosis

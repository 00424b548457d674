#include <fmt/format.h>
#include <gtest/gtest.h>

#include "bridge/scene/SceneDocument.h"

namespace restenosis {
namespace {

class SceneDocumentTest : public ::testing::Test {
 protected:
  SceneDocument document(std::string_view toml) { return {toml, "x.toml", diagnostics}; }
  /// The document after overrides that nothing is wrong with.
  SceneDocument overridden(std::string_view toml, const std::vector<SceneOverride>& overrides) {
    SceneDocument result = document(toml);
    for (const auto& override : overrides) result.apply(override, diagnostics);
    EXPECT_TRUE(diagnostics.empty()) << toString(diagnostics[0]);
    return result;
  }
  /// What is said of an override, and that it changes nothing.
  std::string complaint(const SceneOverride& override) {
    SceneDocument result = document("[a]\n");
    result.apply(override, diagnostics);
    EXPECT_EQ(diagnostics.size(), 1u) << override.text;
    EXPECT_EQ(result.sections().size(), 1u) << override.text;
    EXPECT_TRUE(result.find("a") && result.find("a")->values.empty()) << override.text;
    EXPECT_TRUE(result.removed().empty()) << override.text;
    const std::string text = diagnostics.empty() ? "" : toString(diagnostics[0]);
    diagnostics.clear();
    return text;
  }
  template <class T>
  static T get(const SceneDocument& scene, std::string_view section, std::string_view key) {
    return std::get<T>(scene.find(section)->values.find(key)->second.value);
  }
  std::vector<Diagnostic> diagnostics;
};

TEST_F(SceneDocumentTest, KeepsValuesByKindAndPlace) {
  const auto scene = document("[a]\nyes = true\nwhole = 3\nreal = 2.5\n  text = \"1 mm\"\n\n[b]\n");
  EXPECT_TRUE(diagnostics.empty());
  EXPECT_FALSE(scene.broken());
  EXPECT_EQ(scene.sections().size(), 2u);
  EXPECT_EQ(get<bool>(scene, "a", "yes"), true);
  EXPECT_EQ(get<std::int64_t>(scene, "a", "whole"), 3);
  EXPECT_EQ(get<double>(scene, "a", "real"), 2.5);
  EXPECT_EQ(get<std::string>(scene, "a", "text"), "1 mm");
  EXPECT_EQ(scene.find("c"), nullptr);
}

TEST_F(SceneDocumentTest, KnowsWhereThingsStand) {
  const auto scene = document("[a]\nwhole = 3\n\n  [b]\n");
  EXPECT_EQ(scene.placeOf("a", "whole").line, 2);
  EXPECT_EQ(scene.placeOf("a", "missing").line, 1) << "the section's";
  EXPECT_EQ(scene.placeOf("b", "").line, 4);
  EXPECT_EQ(scene.placeOf("b", "").column, 4);
  EXPECT_EQ(scene.placeOf("missing", "key").line, 1) << "the file's";
  EXPECT_EQ(scene.placeOf("missing", "key").file, "x.toml");
}

TEST_F(SceneDocumentTest, RefusesLettersOutsideOfQuotes) {
  for (const char* letter : {"\u00df", "\u015a", "\u0499", "\u8840", "\u00a0", "\U0001fac0"}) {
    for (const std::string& toml :
         {fmt::format("[a]\nb = {}\n", letter), fmt::format("[a]\nb = 1 {}\n", letter),
          fmt::format("[a]\n{} = 1\n", letter), fmt::format("[a]\nb = \"\"\"\\ {}\"\"\"\n", letter)}) {
      diagnostics.clear();
      EXPECT_TRUE(document(toml).broken()) << toml;
      ASSERT_EQ(diagnostics.size(), 1u) << toml;
      EXPECT_EQ(diagnostics[0].line, 2) << toml;
    }
    diagnostics.clear();
    EXPECT_EQ(get<std::string>(document(fmt::format("[a]\nb = \"{}\" # {}\n", letter, letter)), "a", "b"),
              letter);
  }
}

TEST_F(SceneDocumentTest, NamesTheKindsNoKeyHas) {
  const auto scene = document("[a]\nlist = [1]\ntable = {b = 1}\nday = 2020-01-01\n[a.c]\n");
  EXPECT_TRUE(diagnostics.empty());
  EXPECT_EQ(get<UnusableValue>(scene, "a", "list").kind, "a list");
  EXPECT_EQ(get<UnusableValue>(scene, "a", "table").kind, "a table");
  EXPECT_EQ(get<UnusableValue>(scene, "a", "day").kind, "a date or time");
  EXPECT_EQ(get<UnusableValue>(scene, "a", "c").kind, "a table");
}

TEST_F(SceneDocumentTest, BrokenTomlIsOneMessageAndNoSections) {
  const auto scene = document("[a]\nlength = 1 mm\n");
  EXPECT_TRUE(scene.broken());
  EXPECT_TRUE(scene.sections().empty());
  ASSERT_EQ(diagnostics.size(), 1u);
  EXPECT_EQ(diagnostics[0].line, 2);
  EXPECT_NE(diagnostics[0].message.find("stands in quotes"), std::string::npos) << diagnostics[0].message;
}

TEST_F(SceneDocumentTest, WhatStandsOutsideOfSectionsIsNamedWithItsLine) {
  const auto scene = document("seed = 1\n[a]\n[[b]]\n");
  EXPECT_FALSE(scene.broken());
  EXPECT_EQ(scene.sections().size(), 1u);
  ASSERT_EQ(diagnostics.size(), 2u);
  for (const auto& diagnostic : diagnostics) {
    const bool key = diagnostic.line == 1;
    EXPECT_EQ(diagnostic.line, key ? 1 : 3);
    EXPECT_NE(diagnostic.message.find(key ? "'seed' stands outside of any section" : "[[b]] is a list"),
              std::string::npos)
        << diagnostic.message;
  }
}

TEST_F(SceneDocumentTest, AnOverrideReplacesAddsAndMakesItsSection) {
  const auto scene = overridden("[a]\nwhole = 3\n", {"a.whole=4", "a.real = 2.5", "b.flag=true"});
  EXPECT_EQ(get<std::int64_t>(scene, "a", "whole"), 4);
  EXPECT_EQ(get<double>(scene, "a", "real"), 2.5);
  EXPECT_EQ(get<bool>(scene, "b", "flag"), true);
  EXPECT_EQ(scene.placeOf("a", "whole").file, "--set a.whole");
  EXPECT_EQ(scene.placeOf("a", "whole").line, 0);
  EXPECT_EQ(scene.placeOf("b", "").file, "--set b.flag");
}

TEST_F(SceneDocumentTest, AnOverridesTextNeedsNoQuotes) {
  const auto scene = overridden("", {"a.length= 1.2 mm ", "a.word=foam", "a.quoted=\"foam\"", "a.equal=x=y",
                                     "a.empty=", "a.two=1\nb = 2"});
  EXPECT_EQ(get<std::string>(scene, "a", "length"), "1.2 mm");
  EXPECT_EQ(get<std::string>(scene, "a", "word"), "foam");
  EXPECT_EQ(get<std::string>(scene, "a", "quoted"), "foam");
  EXPECT_EQ(get<std::string>(scene, "a", "equal"), "x=y");
  EXPECT_EQ(get<std::string>(scene, "a", "empty"), "");
  EXPECT_EQ(get<std::string>(scene, "a", "two"), "1\nb = 2") << "one value, not a document";
  EXPECT_EQ(scene.find("a")->values.find("quoted")->second.raw, "\"foam\"") << "as typed";
}

TEST_F(SceneDocumentTest, SectionsComeAndGo) {
  const auto scene = overridden("[a]\nwhole = 3\n[b]\n", {"a=absent", "b=present", "c=present", "d=absent"});
  EXPECT_EQ(scene.find("a"), nullptr);
  EXPECT_NE(scene.find("c"), nullptr);
  EXPECT_EQ(scene.placeOf("b", "").file, "x.toml") << "it was there";
  EXPECT_EQ(scene.placeOf("c", "").file, "--set c");
  ASSERT_EQ(scene.removed().size(), 2u);
  EXPECT_EQ(scene.removed().at("a").file, "--set a");
  EXPECT_EQ(scene.removed().count("d"), 1u) << "whether there was one or not";
}

TEST_F(SceneDocumentTest, OverridesThatSayNothingAreRefused) {
  EXPECT_NE(complaint("a.b").find("--set a.b: no value; write section.key=value"), std::string::npos);
  EXPECT_NE(complaint("").find("--set '': no value"), std::string::npos);
  EXPECT_NE(complaint("=3").find("no section"), std::string::npos);
  EXPECT_NE(complaint(".b=3").find("no section"), std::string::npos);
  EXPECT_NE(complaint("a. =3").find("no key"), std::string::npos);
  EXPECT_NE(complaint("a=3").find("write a.key=value for a key, or a=absent or a=present"),
            std::string::npos);
  EXPECT_NE(complaint("a.b=\xff").find("UTF-8"), std::string::npos);
}

TEST(SceneDocument, NamesTheLineOfAHeaderWithoutAName) {
  for (const char* header : {"[#vessel]", "[", "[[[", "[ #", "[=", "[*"}) {
    std::vector<Diagnostic> found;
    const SceneDocument document(fmt::format("[scene]\nseed = 1\n{}\nlength = 1\n", header), "x.toml", found);
    EXPECT_TRUE(document.broken()) << header;
    ASSERT_EQ(found.size(), 1u) << header;
    EXPECT_EQ(found[0].line, 3) << header;
  }
}

}  // namespace
}  // namespace restenosis

#include <gtest/gtest.h>

#include <stdexcept>

#include "bridge/surface/StlText.h"

namespace restenosis {
namespace {

constexpr std::string_view twoSolids = R"(solid  the inlet
  facet normal 0 0 1
    outer loop
      vertex 0 0 0
      vertex +1.5 0 -2e-3
      vertex 0 1 0
    endloop
  endfacet
endsolid the inlet

solid
facet normal 0 0 1
outer loop
vertex 0 0 0
vertex 1 0 0
vertex 0 1 7
endloop
endfacet
endsolid
)";

std::string replaced(std::string_view text, std::string_view from, std::string_view to) {
  std::string result(text);
  for (auto at = result.find(from); at != std::string::npos; at = result.find(from, at + to.size()))
    result.replace(at, from.size(), to);
  return result;
}

std::string refusalOfStlText(std::string_view text) {
  try {
    parseStlText(text, "x.stl");
    return "accepted";
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

void expectTwoSolids(std::string_view text) {
  const FileTriangles read = parseStlText(text, "x.stl");
  ASSERT_EQ(read.corners.size(), 2u);
  EXPECT_EQ(read.corners[0], (std::array<double, 9>{0, 0, 0, 1.5, 0, -2e-3, 0, 1, 0}));
  EXPECT_EQ(read.corners[1][8], 7.0);
  EXPECT_EQ(read.solid, (std::vector<std::uint32_t>{0, 1}));
  EXPECT_EQ(read.names, (std::vector<std::string>{"the inlet", ""}));
}

TEST(StlText, SolidsAreRead) {
  expectTwoSolids(twoSolids);
  expectTwoSolids(replaced(twoSolids, "\n", "\r\n"));
  expectTwoSolids(replaced(twoSolids, "\n", "\r"));
  expectTwoSolids(replaced(twoSolids, "facet normal", "color 1 0 0\nfacet normal"));
}

TEST(StlText, NumbersKeepTheirDigits) {
  const FileTriangles read = parseStlText(replaced(twoSolids, "1.5", "100000.123456789"), "x.stl");
  EXPECT_EQ(read.corners[0][3], 100000.123456789);
}

TEST(StlText, WordsMayBeInAnyCase) {
  std::string text = replaced(twoSolids, "solid", "SOLID");
  for (const auto& [word, shouted] :
       {std::pair{"facet", "FACET"}, {"outer loop", "Outer Loop"}, {"vertex", "VERTEX"}, {"end", "END"}})
    text = replaced(text, word, shouted);
  expectTwoSolids(text);
}

TEST(StlText, AByteOrderMarkAndAMissingLastEndAreAccepted) {
  expectTwoSolids(std::string("\xEF\xBB\xBF").append(twoSolids));
  expectTwoSolids(twoSolids.substr(0, twoSolids.rfind("endsolid")));
}

TEST(StlText, ALineMayHoldSeveralStatementsOrAll) {
  const std::string named = replaced(twoSolids, "solid\n", "solid next\n");
  for (const std::string& line :
       {replaced(twoSolids, "\n", " "), replaced(twoSolids, "\n", "\t "),
        replaced(twoSolids, "\nvertex", " vertex"), replaced(twoSolids, "normal 0 0 1\n", "normal 0 0 1 "),
        replaced(twoSolids, "outer loop\n", "OUTER LOOP "), replaced(twoSolids, "endfacet\n", "endfacet ")})
    expectTwoSolids(line);
  const FileTriangles read = parseStlText(replaced(named, "\n", " "), "x.stl");
  EXPECT_EQ(read.names, (std::vector<std::string>{"the inlet", "next"}));
  EXPECT_EQ(read.corners.size(), 2u);
  EXPECT_EQ(refusalOfStlText(replaced(replaced(twoSolids, "vertex 1 0 0", "vertex 1 0"), "\n", " ")),
            "x.stl:1: expected 'vertex' and three numbers, found 'vertex 1 0'");
}

TEST(StlText, NamesMayHoldWordsOfStl) {
  for (const char* name : {"solid part", "a facet of it", "my solid", "outer loop", "vertex normal"}) {
    const std::string text = replaced(twoSolids, "the inlet", name);
    const FileTriangles read = parseStlText(text, "x.stl");
    EXPECT_EQ(read.names, (std::vector<std::string>{name, ""}));
    EXPECT_EQ(read.corners.size(), 2u);
  }
}

TEST(StlText, ASolidMayFollowTheLastInItsLine) {
  for (const char* between : {"", " "}) {
    const auto at = twoSolids.find("\n\nsolid\n");
    expectTwoSolids(std::string(twoSolids.substr(0, at)) + between + std::string(twoSolids.substr(at + 2)));
  }
}

TEST(StlText, TheFirstWrongLineIsNamed) {
  EXPECT_EQ(refusalOfStlText("ply\nformat ascii 1.0\n"),
            "x.stl:1: expected 'solid', found 'ply': is it an STL file?");
  EXPECT_EQ(refusalOfStlText(replaced(twoSolids, "vertex 1 0 0", "vertx 1 0 0")),
            "x.stl:15: expected 'vertex', found 'vertx 1 0 0'");
  EXPECT_EQ(refusalOfStlText(replaced(twoSolids, "1.5", "1,5")),
            "x.stl:5: '+1,5' is not a number: its decimals need a point");
  EXPECT_EQ(refusalOfStlText(replaced(twoSolids, "1.5", "1.5mm")), "x.stl:5: '+1.5mm' is not a number");
  EXPECT_EQ(refusalOfStlText(replaced(twoSolids, "1.5", "nan")),
            "x.stl:5: '+nan' is not a finite number of single precision");
  EXPECT_EQ(refusalOfStlText(replaced(twoSolids, "1.5", "1e39")),
            "x.stl:5: '+1e39' is not a finite number of single precision");
  EXPECT_EQ(refusalOfStlText(replaced(twoSolids, "vertex 1 0 0", "vertex 1 0")),
            "x.stl:15: expected 'vertex' and three numbers, found 'vertex 1 0'");
  EXPECT_EQ(refusalOfStlText(replaced(twoSolids, "vertex 1 0 0", "vertex 1 0 0 0")),
            "x.stl:15: expected 'vertex' and three numbers, found 'vertex 1 0 0 0'");
  EXPECT_EQ(refusalOfStlText(replaced(twoSolids, "endloop", "vertex 1 1 0\nendloop")),
            "x.stl:7: expected 'endloop' after the three vertices of a triangle, found 'vertex 1 1 0'");
  EXPECT_EQ(refusalOfStlText(replaced(twoSolids, "endfacet\n", "")),
            "x.stl:8: expected 'endfacet', found 'endsolid the inlet'");
  EXPECT_EQ(refusalOfStlText(replaced(twoSolids, "endsolid the inlet\n", "")),
            "x.stl:10: expected 'facet' or 'endsolid', found 'solid'");
  std::string fortyTimes;
  for (int k = 0; k < 40; ++k) fortyTimes += "\\x01";
  EXPECT_EQ(refusalOfStlText(std::string(twoSolids) + std::string(50, '\x01')),
            "x.stl:20: expected 'solid', found '" + fortyTimes + "...'");
}

TEST(StlText, ACutIsNamedWithItsLine) {
  EXPECT_EQ(refusalOfStlText(twoSolids.substr(0, twoSolids.find("vertex 0 1 7"))),
            "x.stl:15: the file is cut off: 'vertex' must follow");
  EXPECT_EQ(refusalOfStlText(twoSolids.substr(0, twoSolids.rfind("endloop"))),
            "x.stl:16: the file is cut off: 'endloop' after the three vertices of a triangle must follow");
  EXPECT_EQ(refusalOfStlText(twoSolids.substr(0, twoSolids.rfind("facet") + 2)),
            "x.stl:18: expected 'endfacet', found 'endfa'");
}

}  // namespace
}  // namespace restenosis

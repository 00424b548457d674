#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <stdexcept>

#include "bridge/surface/StlFile.h"
#include "bridge/surface/StlTriangles.h"
#include "tests/support/TemporaryFolder.h"
#include "tests/support/TubeSurface.h"

namespace restenosis {
namespace {

class StlTrianglesFile : public testing::Test {
 protected:
  StlTrianglesFile() {
    writeStl(file, surface, 1e-3);
    whole = readText(file);
  }
  /// What is said about a file of this content.
  std::string refusal(const std::string& content) const {
    writeText(file, content);
    try {
      readStlTriangles(file);
      return "accepted";
    } catch (const std::runtime_error& error) {
      std::string text = error.what();
      EXPECT_TRUE(text.starts_with(file.string())) << text;
      return text.substr(std::min(text.size(), file.string().size()));
    }
  }
  std::string announcing(std::uint32_t triangles) const {
    std::string content = whole;
    std::memcpy(content.data() + 80, &triangles, sizeof(triangles));
    return content;
  }

  const TemporaryFolder folder;
  const std::filesystem::path file = folder / "x.stl";
  const TriSurface surface = support::tube(1e-3, 2e-3);
  const std::size_t count = surface.triangles.size();  // 3328
  std::string whole;
};

TEST_F(StlTrianglesFile, ABinaryFileShorterThanItAnnouncesIsRefused) {
  EXPECT_EQ(refusal(whole), "accepted");
  const std::string says = " is cut off, or is no STL file: its header announces ";
  EXPECT_EQ(refusal(whole.substr(0, whole.size() - 1)), says + "3328 triangles, it has room for 3327");
  EXPECT_EQ(refusal(whole.substr(0, 84 + 50 * 1000)), says + "3328 triangles, it has room for 1000");
  EXPECT_EQ(refusal(announcing(3329)), says + "3329 triangles, it has room for 3328");
  EXPECT_EQ(refusal(whole.substr(0, 83)),
            " is cut off, or is no STL file: it has 83 bytes, the header of a binary one 84");
}

TEST_F(StlTrianglesFile, FewerBytesThanATriangleBehindTheAnnouncedOnesAreLeftAlone) {
  for (const char fill : {'x', '\0', ' ', '\n', '\xFF'})
    for (const std::size_t more : {1, 2, 49}) {
      writeText(file, whole + std::string(more, fill));
      EXPECT_EQ(readStlTriangles(file).corners.size(), count) << more;
    }
}

TEST_F(StlTrianglesFile, MoreThanIsAnnouncedIsReadOrRefusedWithBothCounts) {
  const auto says = [](std::size_t announced, std::size_t room, std::size_t bytes) {
    return fmt::format(
        " holds more than it announces: its header announces {} triangles, it has room for {}, and the {} "
        "bytes behind the announced ones are not whole further solids. Export it again",
        announced, room, bytes);
  };
  for (const char fill : {'x', '\0', ' ', '\n', '\xFF'})
    for (const std::size_t more : {50, 84, 100, 170})
      EXPECT_EQ(refusal(whole + std::string(more, fill)), says(3328, 3328 + more / 50, more)) << int(fill);
  for (const std::size_t fewer : {1, 2, 3, 1000, 3327})
    EXPECT_EQ(refusal(announcing(3328 - fewer)), says(3328 - fewer, 3328, 50 * fewer));
  EXPECT_EQ(refusal(whole + whole.substr(0, whole.size() - 1)), says(3328, 6657, 166483));
  EXPECT_EQ(refusal(whole + whole + std::string(60, 'x')), says(3328, 6658, 166544));
  EXPECT_EQ(refusal(whole + "some text that says what this is, and for whom it was made"),
            says(3328, 3329, 58));
}

TEST_F(StlTrianglesFile, AHeaderThatAnnouncesNoneOfItsTrianglesIsRefused) {
  const std::string says =
      " has a header that announces 0 triangles, but room for 3328: what wrote it has not filled in their "
      "number. Export it again";
  EXPECT_EQ(refusal(announcing(0)), says);
  EXPECT_EQ(refusal(std::string(84, '\0') + whole.substr(84)), says);
  EXPECT_EQ(refusal(announcing(0).substr(0, 84)), " holds no triangles");
  EXPECT_EQ(refusal(announcing(0).substr(0, 84) + "\n"), " holds no triangles");
}

/// Corners and solids of files one after the other.
TEST_F(StlTrianglesFile, FilesOfEitherKindMayBeJoined) {
  writeNamedStl(file, surface, 1e-3);
  const std::string ascii = readText(file), unended = ascii.substr(0, ascii.size() - 1);
  const std::string unnamed = "solid\n" + ascii.substr(ascii.find("facet"), ascii.find("endsolid") - 11) +
                              "endsolid";  // the wall, without names and a last line end
  ASSERT_TRUE(unnamed.ends_with("endfacet\nendsolid"));
  const std::string empty = announcing(0).substr(0, 84);
  using Names = std::vector<std::string>;
  const struct {
    std::string content;
    std::size_t triangles;
    Names names;
  } cases[] = {{whole + whole, 2 * count, {"", ""}},
               {whole + whole + whole + std::string(10, '\0'), 3 * count, {"", "", ""}},
               {empty + whole, count, {"", ""}},
               {whole + empty, count, {"", ""}},
               {whole + empty + whole, 2 * count, {"", "", ""}},
               {whole + ascii, 2 * count, {"", "wall", "inlet", "outlet"}},
               {whole + "\n" + ascii, 2 * count, {"", "wall", "inlet", "outlet"}},
               {whole + unended + whole, 3 * count, {"", "wall", "inlet", "outlet", ""}},
               {ascii + whole, 2 * count, {"wall", "inlet", "outlet", ""}},
               {unended + whole, 2 * count, {"wall", "inlet", "outlet", ""}},
               {unended + ascii, 2 * count, {"wall", "inlet", "outlet", "wall", "inlet", "outlet"}},
               {unnamed + whole, 3072 + count, {"", ""}},
               {unnamed + ascii, 3072 + count, {"", "wall", "inlet", "outlet"}},
               {ascii + whole + ascii + whole + whole,
                5 * count,
                {"wall", "inlet", "outlet", "", "wall", "inlet", "outlet", "", ""}},
               {ascii + std::string(20, '\0') + "\n\x1A", count, {"wall", "inlet", "outlet"}}};
  for (const auto& c : cases) {
    ASSERT_EQ(refusal(c.content), "accepted") << &c - cases;
    const FileTriangles read = readStlTriangles(file);
    EXPECT_EQ(read.corners.size(), c.triangles) << &c - cases;
    EXPECT_EQ(read.solid.size(), c.triangles) << &c - cases;
    EXPECT_EQ(read.names, c.names) << &c - cases;
  }
  // The last triangle and its solid are those of the last file
  writeText(file, ascii + whole);
  const FileTriangles joined = readStlTriangles(file);
  writeText(file, whole);
  EXPECT_EQ(joined.corners.back(), readStlTriangles(file).corners.back());
  EXPECT_EQ(joined.solid.back(), 3u);
}

TEST_F(StlTrianglesFile, WhatFollowsAText) {
  writeNamedStl(file, surface, 1e-3);
  const std::string ascii = readText(file);
  EXPECT_EQ(
      refusal(ascii + std::string(100, '\x01')),
      " holds more than solids: 3328 triangles end with the text, and the 100 bytes behind it, room for "
      "2 more, are not whole further solids. Export it again");
  EXPECT_EQ(refusal(whole + "solid x\nfacet normal 0 0 1\nouter loop\nvertx 0 0 0\n"),
            ", text from byte 166485 on:4: expected 'vertex', found 'vertx 0 0 0'");
}

TEST_F(StlTrianglesFile, ABinaryFileMayBeginAsAnAsciiOne) {
  std::string named = whole;
  named.replace(0, 12, "solid inlet ");
  writeText(file, named);
  const FileTriangles read = readStlTriangles(file);
  EXPECT_EQ(read.corners.size(), count);
  EXPECT_EQ(read.names, std::vector<std::string>{""});
  EXPECT_NE(refusal(named.substr(0, named.size() - 30)).find("is cut off"), std::string::npos);
}

TEST_F(StlTrianglesFile, BothKindsHaveTheSameTriangles) {
  const FileTriangles binary = readStlTriangles(file);
  writeNamedStl(file, surface, 1e-3);
  const FileTriangles ascii = readStlTriangles(file);
  EXPECT_EQ(ascii.names, (std::vector<std::string>{"wall", "inlet", "outlet"}));
  EXPECT_EQ(std::count(ascii.solid.begin(), ascii.solid.end(), 0u), 3072);
  ASSERT_EQ(ascii.corners.size(), count);
  const auto sameInSinglePrecision = [](double a, double b) {
    return static_cast<float>(a) == static_cast<float>(b);
  };
  for (std::size_t t = 0; t < 3072; ++t)
    EXPECT_TRUE(std::ranges::equal(ascii.corners[t], binary.corners[t], sameInSinglePrecision)) << t;
}

TEST_F(StlTrianglesFile, WhatIsNoStlIsNamed) {
  EXPECT_EQ(refusal(""), " is empty: it must be an STL file");
  EXPECT_EQ(refusal("solid nothing\nendsolid nothing\n"), " holds no triangles");
  EXPECT_EQ(refusal("not a surface"), ":1: expected 'solid', found 'not a surface': is it an STL file?");
  std::string broken = whole;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  std::memcpy(broken.data() + 84 + 6 * 50 + 12, &nan, sizeof(nan));
  EXPECT_EQ(refusal(broken), " has a vertex that is not a finite number, in triangle 7 of 3328");
  std::filesystem::remove(file);
  EXPECT_THROW(readStlTriangles(file), std::runtime_error);
  EXPECT_THROW(readStlTriangles(folder.path()), std::runtime_error);
}

}  // namespace
}  // namespace restenosis

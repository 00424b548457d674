#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <stdexcept>

#include "StlFile.h"
#include "StlTriangles.h"
#include "TemporaryFolder.h"
#include "TubeSurface.h"

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

TEST_F(StlTrianglesFile, BytesAfterTheAnnouncedTrianglesAreLeftAlone) {
  for (const std::size_t more : {1, 49, 50, 170}) {
    writeText(file, whole + std::string(more, 'x'));
    EXPECT_EQ(readStlTriangles(file).corners.size(), count) << more;
  }
}

TEST_F(StlTrianglesFile, ABinaryFileMayBeginAsAnAsciiOne) {
  std::string named = whole;
  named.replace(0, 12, "solid inlet ");
  writeText(file, named);
  const StlTriangles read = readStlTriangles(file);
  EXPECT_EQ(read.corners.size(), count);
  EXPECT_EQ(read.names, std::vector<std::string>{""});
  EXPECT_NE(refusal(named.substr(0, named.size() - 30)).find("is cut off"), std::string::npos);
}

TEST_F(StlTrianglesFile, BothKindsHaveTheSameTriangles) {
  const StlTriangles binary = readStlTriangles(file);
  writeNamedStl(file, surface, 1e-3);
  const StlTriangles ascii = readStlTriangles(file);
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
  EXPECT_EQ(refusal(announcing(0)), " holds no triangles");
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

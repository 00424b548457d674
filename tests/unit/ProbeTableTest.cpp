#include <gtest/gtest.h>

#include "bridge/compare/ProbeTable.h"
#include "tests/support/ExpectSays.h"
#include "tests/support/TemporaryFolder.h"

namespace restenosis {
namespace {

class ProbeTable : public ::testing::Test {
 protected:
  std::vector<Vec3> read(const std::string& text) const {
    writeText(folder / "points.csv", text);
    return readProbes(folder / "points.csv");
  }
  std::string refusal(const std::string& text) const {
    try {
      read(text);
    } catch (const TableError& error) {
      return error.what();
    }
    return "";
  }
  TemporaryFolder folder;
};

TEST_F(ProbeTable, holdsPointsInMillimetres) {
  const auto points = read("x_mm,y_mm,z_mm\n# on the axis\n0,0,-8\n\n 1.5, 0 ,24  # beside it\r\n");
  ASSERT_EQ(points.size(), 2u);
  EXPECT_NEAR((points[0] - Vec3(0, 0, -8e-3)).norm(), 0, 1e-15);
  EXPECT_NEAR((points[1] - Vec3(1.5e-3, 0, 24e-3)).norm(), 0, 1e-15);
}

TEST_F(ProbeTable, saysWhatIsWrongAndWhere) {
  EXPECT_SAYS(refusal("x,y,z\n0,0,0\n"),
              "points.csv:1: the first line is 'x,y,z'; it must be x_mm,y_mm,z_mm");
  EXPECT_SAYS(refusal("x_mm,y_mm,z_mm\n0,0,0\n1,2\n"), "points.csv:3: '1,2' is not three numbers");
  EXPECT_SAYS(refusal("x_mm,y_mm,z_mm\n0,0,0,0\n"), "points.csv:2: ");
  EXPECT_SAYS(refusal("x_mm,y_mm,z_mm\n0,inf,0\n"), "points.csv:2: ");
  EXPECT_SAYS(refusal("x_mm,y_mm,z_mm\n0,1e,0\n"), "points.csv:2: ");
  EXPECT_SAYS(refusal("x_mm,y_mm,z_mm\n"), "holds no points");
  EXPECT_SAYS(refusal(""), "holds no points");
  EXPECT_THROW(readProbes(folder / "none.csv"), TableError);
}

}  // namespace
}  // namespace restenosis

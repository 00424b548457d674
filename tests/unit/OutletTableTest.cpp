#include <gtest/gtest.h>

#include "bridge/flow/OutletTable.h"
#include "tests/support/ExpectSays.h"
#include "tests/support/TemporaryFolder.h"

namespace restenosis {
namespace {

class OutletTable : public ::testing::Test {
 protected:
  std::vector<Outlet> read(const std::string& text) const {
    writeText(folder_ / "outlets.csv", text);
    return readOutlets(folder_ / "outlets.csv");
  }
  std::string refused(const std::string& text) const {
    try {
      read(text);
    } catch (const TableError& error) {
      return error.what();
    }
    return "accepted";
  }

 private:
  TemporaryFolder folder_;
};

TEST_F(OutletTable, HasShares) {
  const auto outlets = read("# Murray\n\nsolid,share\n\"b, of two\",0.3004\n a , 0.7\n");
  ASSERT_EQ(outlets.size(), 2U);
  EXPECT_EQ(outlets[0].name, "a");
  EXPECT_EQ(outlets[1].name, "b, of two");
  EXPECT_NEAR(outlets[0].share, 0.7 / 1.0004, 1e-15);
  EXPECT_DOUBLE_EQ(outlets[0].share + outlets[1].share, 1);
  EXPECT_EQ(outlets[0].resistance, 0);
}

TEST_F(OutletTable, HasResistancesThatMakeAGuessOfShares) {
  const auto outlets = read("solid,resistance\na,1e9\nb,3e9\n");
  EXPECT_EQ(outlets[1].resistance, 3e9);
  EXPECT_DOUBLE_EQ(outlets[0].share, 0.75);
}

TEST_F(OutletTable, ThatIsWrongIsRefusedWithItsLine) {
  EXPECT_SAYS(refused("name,share\na,1\n"), "outlets.csv:1: 'name,share' is no header of a table of outlets");
  EXPECT_SAYS(refused("solid,share\na,0.5\nb,-0.5\n"),
              ":3: 'b,-0.5' is not the name of a solid and a positive share");
  EXPECT_SAYS(refused("solid,resistance\na,1e9\nb,inf\n"), "a positive resistance");
  EXPECT_SAYS(refused("solid,share\na,0.5\na,0.5\n"), ":3: the solid 'a' is there twice");
  EXPECT_SAYS(refused("solid,share\na,0.5\nb,0.6\n"), "the shares are 1.1 together; they must be 1");
  EXPECT_SAYS(refused("solid,share\na,1\n"), "holds 1 outlets; a lumen with one needs no table");
  EXPECT_SAYS(refused(""), "holds 0 outlets");
  EXPECT_THROW(readOutlets("/nowhere.csv"), TableError);
}

}  // namespace
}  // namespace restenosis

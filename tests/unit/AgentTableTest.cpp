#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <tuple>

#include "tissue/vessel/AgentTable.h"

namespace restenosis {
namespace {

class AgentTableTest : public testing::Test {
 protected:
  ~AgentTableTest() override { std::filesystem::remove(file); }
  void write(const std::string& text) { std::ofstream(file) << text; }
  std::string errorOf(const std::string& text) {
    write(text);
    try {
      readAgentTable(file);
    } catch (const TableError& error) {
      return error.what();
    }
    return "no error";
  }
  std::filesystem::path file =
      std::filesystem::temp_directory_path() / ("agents-" + std::to_string(getpid()) + ".csv");
};

TEST_F(AgentTableTest, ReadsWhatItWrote) {
  AgentStore agents;
  agents.append(AgentKind::iel, {915e-6, -1.25e-9, 1.0 / 3 * 1e-3}, 15e-6);
  agents.append(AgentKind::strut, {0, 0, 0}, 7.5e-6);
  agents.birthRadius[0] = 12.5e-6;
  writeAgentTable(file, agents);
  const AgentStore read = readAgentTable(file).agents;
  ASSERT_EQ(read.size(), 2u);
  for (Index i = 0; i < 2; ++i) {
    EXPECT_LT((read.position(i) - agents.position(i)).norm(), 1e-18);
    EXPECT_NEAR(read.radius[i], agents.radius[i], 1e-20);
    EXPECT_EQ(read.kind[i], agents.kind[i]);
    EXPECT_NEAR(read.birthRadius[i], agents.birthRadius[i], 1e-20);
  }
}

TEST_F(AgentTableTest, CellsAreAsLargeAsTheyWereBornUnlessItSaysOtherwise) {
  write("x,y,z,radius\n1,2,3,18\n");
  EXPECT_EQ(readAgentTable(file).agents.birthRadius[0], readAgentTable(file).agents.radius[0]);
  write("x,y,z,birthRadius,radius\n1,2,3,15,18\n1,2,9,15,18.898\n1,2,9,15,15\n");
  for (const double atBirth : readAgentTable(file).agents.birthRadius) EXPECT_NEAR(atBirth, 15e-6, 1e-18);
}

TEST_F(AgentTableTest, TakesColumnsInAnyOrderAndTheDefaultKind) {
  write("# made by hand\nradius, z, y, x\r\n\n15, 3, 2, 1\r\n");
  const AgentStore agents = readAgentTable(file, AgentKind::strut).agents;
  ASSERT_EQ(agents.size(), 1u);
  EXPECT_LT((agents.position(0) - Vec3(1e-6, 2e-6, 3e-6)).norm(), 1e-18);
  EXPECT_EQ(agents.kind[0], AgentKind::strut);
}

TEST_F(AgentTableTest, TakesWhatSpreadsheetsAndHandsWrite) {
  write("\xEF\xBB\xBFx,y,z,radius,kind # um\n+1,2,3,+1.5e1,smc # first\n  # none\n4,5,6,15,iel#last\n");
  const AgentTable table = readAgentTable(file);
  ASSERT_EQ(table.agents.size(), 2u);
  EXPECT_LT((table.agents.position(0) - Vec3(1e-6, 2e-6, 3e-6)).norm(), 1e-18);
  EXPECT_NEAR(table.agents.radius[0], 15e-6, 1e-18);
  EXPECT_EQ(table.agents.kind[1], AgentKind::iel);
  EXPECT_EQ(table.lines, (std::vector<std::size_t>{2, 4}));
}

TEST_F(AgentTableTest, TakesLinesThatEndWithCarriageReturns) {
  write("x,y,z,radius,kind\r1,2,3,15,smc\r\r4,5,6,15,iel\r");
  const AgentTable table = readAgentTable(file);
  ASSERT_EQ(table.agents.size(), 2u);
  EXPECT_EQ(table.agents.kind[1], AgentKind::iel);
  EXPECT_EQ(table.lines, (std::vector<std::size_t>{2, 4}));
}

TEST_F(AgentTableTest, ShowsNoMoreOfACellThanFitsALine) {
  const std::string longText(100000, 'a');
  for (const std::string& text :
       {longText + "\n", "x,y,z,radius\n1,2,3," + longText + "\n",
        "x,y,z,radius,kind\n1,2,3,15," + longText + "\n", longText + "," + longText + "\n"})
    EXPECT_LT(errorOf(text).size(), file.string().size() + 200);
  EXPECT_NE(errorOf("x,y,z,\x1b[31mred\n").find("unknown column '\\x1b[31mred'"), std::string::npos);
}

TEST_F(AgentTableTest, SaysThatCommasSeparate) {
  const std::string header = "x,y,z,radius,kind\n";
  for (const auto& [text, line, mark] :
       {std::tuple<std::string, int, std::string>{"x;y;z;radius\n1;2;3;15\n", 1, "semicolons"},
        {"x\ty\tz\tradius\n1\t2\t3\t15\n", 1, "tabs"},
        {"x|y|z|radius\n", 1, "bars"},
        {"x y z radius\n", 1, "blanks"},
        {"\"x\";\"y\";\"z\";\"radius\"\n", 1, "semicolons"},
        {"x,y,z,radius;\n", 1, "semicolons"},
        {header + "1;2;3;15;smc\n", 2, "semicolons"},
        {header + "1,5;2,5;3,5;15,0;smc\n", 2, "semicolons"},
        {header + "1,2,3,15,smc\n1\t2\t3\t15\tsmc\n", 3, "tabs"},
        {header + "1 2 3 15 smc\n", 2, "blanks"}}) {
    const std::string error = errorOf(text);
    EXPECT_TRUE(error.starts_with(file.string() + ":" + std::to_string(line) + ": ")) << error;
    EXPECT_NE(error.find("its cells seem to be separated by " + mark + ", but commas separate"),
              std::string::npos)
        << error;
  }
}

TEST_F(AgentTableTest, NamesFileAndLineOfEveryError) {
  const std::string header = "x,y,z,radius,kind\n";
  const std::pair<std::string, std::string> cases[] = {
      {"x,y,z\n1,2,3\n", ":1: column 'radius' is missing"},
      {"x,y,z,radius,colour\n",
       ":1: unknown column 'colour'. Allowed: x, y, z, radius, kind, birthRadius (lengths in um)"},
      {"x,y,z,radus\n", ":1: unknown column 'radus'; did you mean 'radius'? Allowed: x"},
      {"x,y,x,radius\n", ":1: column 'x' appears twice"},
      {header + "1,2,3,15\n", ":2: 4 cells where the header names 5 columns"},
      {header + "1,2,3,15,smc\n1,two,3,15,smc\n", ":3: column 'y': 'two' is not a finite number"},
      {header + "1,nan,3,15,smc\n", ":2: column 'y': 'nan' is not a finite number"},
      {header + "1,+-2,3,15,smc\n", ":2: column 'y': '+-2' is not a finite number"},
      {header + "1,++2,3,15,smc\n", ":2: column 'y': '++2' is not a finite number"},
      {header + "1,+,3,15,smc\n", ":2: column 'y': '+' is not a finite number"},
      {header + "1,2,3 # ,15,smc\n", ":2: 3 cells where the header names 5 columns"},
      {header + "1,,3,15,smc\n", ":2: column 'y': '' is not a finite number"},
      {header + "1,2,3,0,smc\n", ":2: the radius must be larger than 0 um"},
      {header + "1,2,3,15,ecm\n",
       ":2: unknown kind 'ecm'; did you mean 'smc'? Allowed: smc, iel, eel, strut"},
      {header + "1,2,3,15,collagen\n", ":2: unknown kind 'collagen'. Allowed: smc, iel, eel, strut"},
      {"x,y,z,radius,birthRadius\n1,2,3,18,14\n",
       ":2: a birthRadius of 14 um; allowed are 14.2866 to 18 um: a cell of the radius 18 um has at most "
       "twice"},
      {"x,y,z,radius,birthRadius\n1,2,3,18,19\n", ":2: a birthRadius of 19 um; allowed are 14.2866 to 18 um"},
      {"x,y,z,radius,birthRadius\n1,2,3,18,\n", ":2: column 'birthRadius': '' is not a finite number"},
      {header, ": holds no agents"}};
  for (const auto& [text, message] : cases) {
    const std::string error = errorOf(text);
    EXPECT_TRUE(error.starts_with(file.string() + message)) << error;
  }
  EXPECT_THROW(readAgentTable("/nowhere/agents.csv"), TableError);
  EXPECT_THROW(writeAgentTable("/nowhere/agents.csv", AgentStore()), TableError);
}

}  // namespace
}  // namespace restenosis

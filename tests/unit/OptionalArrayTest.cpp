#include <gtest/gtest.h>

#include "tests/support/Constants.h"
#include "tissue/agents/AgentStore.h"
#include "tissue/agents/StateArchive.h"

namespace restenosis {
namespace {

using namespace support;

AgentStore threeAgents() {
  AgentStore agents;
  for (int n = 0; n < 3; ++n) agents.append(AgentKind::smc, Vec3(n, 0, 0), r);
  return agents;
}

TEST(OptionalArray, IsNothingUntilItIsModelled) {
  AgentStore agents = threeAgents();
  EXPECT_FALSE(agents.activation.modelled());
  EXPECT_EQ(agents.activation[2], 0);
  EXPECT_EQ(agents.cellRadius(1), r);
  WritingArchive without;
  without(agents);
  agents.activation.model(agents.size());
  WritingArchive with;
  with(agents);
  EXPECT_EQ(with.buffer().size(), without.buffer().size() + sizeof(std::uint64_t) + 3 * sizeof(float));
}

TEST(OptionalArray, FollowsTheAgents) {
  AgentStore agents = threeAgents();
  agents.matrix.model(agents.size());
  for (Index i = 0; i < 3; ++i) agents.matrix.set(i, static_cast<float>(i + 1));
  agents.append(AgentKind::smc, Vec3(3, 0, 0), r);
  EXPECT_EQ(agents.matrix[3], 0);
  agents.reorder(std::vector<Index>{2, 0, 3, 1});
  EXPECT_EQ(agents.matrix.values(), (std::vector<float>{3, 1, 0, 2}));
  agents.erase(std::vector<std::uint8_t>{0, 1, 0, 0});
  EXPECT_EQ(agents.matrix.values(), (std::vector<float>{3, 0, 2}));

  WritingArchive written;
  written(agents);
  AgentStore again;
  again.matrix.model(0);
  ReadingArchive reading(written.buffer());
  reading(again);
  EXPECT_TRUE(reading.atEnd());
  EXPECT_EQ(again.matrix.values(), agents.matrix.values());
}

TEST(AgentStore, TakesCellAndMatrixAsOneSphere) {
  AgentStore agents = threeAgents();
  agents.matrix.model(agents.size());
  const auto matrix = static_cast<float>(7 * r * r * r);
  agents.setCell(0, r, matrix);
  EXPECT_NEAR(agents.radius[0], 2 * r, 1e-6 * r);
  EXPECT_NEAR(agents.cellRadius(0), r, 1e-12 * r);
  EXPECT_NEAR(agents.matrixShare(0), 7.0 / 8, 1e-6);
  agents.setCell(0, r, 0);
  EXPECT_EQ(agents.radius[0], r);
}

}  // namespace
}  // namespace restenosis

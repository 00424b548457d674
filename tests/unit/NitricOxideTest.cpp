#include <gtest/gtest.h>

#include <stdexcept>

#include "tissue/biology/NitricOxide.h"

namespace restenosis {
namespace {

TEST(NitricOxide, FollowsThePublishedPieces) {
  const NitricOxide law{EndotheliumParameters{}};
  const auto published = [](double dynPerCm2) {
    return dynPerCm2 <= 10.5 ? 0.000366 * dynPerCm2
                             : 0.00052 * dynPerCm2 * dynPerCm2 - 0.011 * dynPerCm2 + 0.062;
  };
  for (const double dynPerCm2 : {0.0, 1.0, 2.73, 5.0, 10.5, 10.8, 12.0, 16.0, 30.0, 100.0}) {
    EXPECT_NEAR(law.concentration(0.1 * dynPerCm2), published(dynPerCm2), 1e-12) << dynPerCm2;
  }
}

TEST(NitricOxide, IsContinuousAndNeverFalls) {
  const NitricOxide law{EndotheliumParameters{}};
  EXPECT_NEAR(law.concentration(1.05), 0.00384, 0.5e-5);
  EXPECT_NEAR(law.concentration(1.05 + 1e-9), law.concentration(1.05), 1e-9);
  for (int k = 0; k < 3000; ++k) {
    EXPECT_LE(law.concentration(0.001 * k), law.concentration(0.001 * (k + 1))) << k;
  }
  EXPECT_EQ(law.concentration(-1.0), 0.0);
}

TEST(NitricOxide, HasAnInverse) {
  const NitricOxide law{EndotheliumParameters{}};
  EXPECT_NEAR(law.wssForNitricOxide(0.001), 0.273, 0.0005);
  EXPECT_NEAR(law.wssForNitricOxide(0.0004), 0.109, 0.0005);
  for (const double threshold : {0.0005, 0.003, 0.0039, 0.01, 0.2}) {
    EXPECT_NEAR(law.concentration(law.wssForNitricOxide(threshold)), threshold, 1e-12 + 1e-9 * threshold);
  }
}

TEST(NitricOxide, IsMadeByCoveredSmcOnly) {
  AgentStore agents;
  for (const AgentKind kind : {AgentKind::smc, AgentKind::smc, AgentKind::iel}) {
    const Index i = agents.append(kind, Vec3::Zero(), 15e-6);
    agents.wss[i] = 1.0;
    agents.nitricOxide[i] = 7.0;
  }
  agents.set(0, covered, true);
  agents.set(2, covered, true);
  NitricOxide{EndotheliumParameters{}}.apply(agents);
  EXPECT_DOUBLE_EQ(agents.nitricOxide[0], 0.00366);
  EXPECT_EQ(agents.nitricOxide[1], 0.0);
  EXPECT_EQ(agents.nitricOxide[2], 0.0);
}

TEST(NitricOxide, RefusesALawThatFalls) {
  EndotheliumParameters parameters;
  parameters.nitricOxideConstant = 0.1;
  EXPECT_THROW(NitricOxide{parameters}, std::invalid_argument);
}

}  // namespace
}  // namespace restenosis

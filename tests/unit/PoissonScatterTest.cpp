#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "tissue/agents/RandomStream.h"
#include "tissue/vessel/Cylindrical.h"
#include "tissue/vessel/PoissonScatter.h"

namespace restenosis {
namespace {

constexpr std::uint64_t seed = 7;
constexpr double length = 100e-6, innerRadius = 60e-6, outerRadius = 110e-6;

double radiusOfId(AgentId id) { return (8 + static_cast<double>(id % 5)) * 1e-6; }

/// What PoissonScatter says it does, one agent after the other, each compared with all before it.
std::vector<Vec3> placesOneByOne(AgentId count) {
  std::vector<Vec3> places;
  double share = 0.82;
  const auto isFree = [&](AgentId id, const Vec3& place) {
    for (AgentId other = 0; other < id; ++other) {
      const double reach = share * (radiusOfId(id) + radiusOfId(other));
      if ((places[other] - place).squaredNorm() < reach * reach) return false;
    }
    return true;
  };
  for (AgentId id = 0; id < count; ++id) {
    RandomStream stream(seed, id, 0, RandomPurpose::packing);
    for (int tries = 1;; ++tries) {
      const double least = innerRadius * innerRadius, most = outerRadius * outerRadius;
      const double fromAxis = std::sqrt(least + (most - least) * stream.uniform());
      const double angle = 2 * std::numbers::pi * stream.uniform();
      const Vec3 place = toCartesian({fromAxis, angle, length * stream.uniform()});
      if (isFree(id, place)) {
        places.push_back(place);
        break;
      }
      if (tries % 200 == 0) share *= 0.99;
    }
  }
  return places;
}

TEST(PoissonScatter, FindsThePlacesThatAgentsOneByOneWould) {
  constexpr Index count = 900;  // more than there is space for at the full share
  AgentStore agents;
  PoissonScatter scatter(seed, length, outerRadius, 900, 12e-6);
  const SurfaceFromAxis inner(innerRadius), outer(outerRadius);
  scatter.add(agents, AgentKind::smc, count, radiusOfId, inner, outer);

  ASSERT_EQ(agents.size(), count);
  const std::vector<Vec3> expected = placesOneByOne(count);
  double leastShare = 1;
  for (Index i = 0; i < count; ++i) {
    ASSERT_LT((agents.position(i) - expected[i]).norm(), 1e-15) << i;  // rounding apart
    ASSERT_EQ(agents.radius[i], radiusOfId(i));
    for (Index j = 0; j < i; ++j)
      leastShare =
          std::min(leastShare, (expected[i] - expected[j]).norm() / (agents.radius[i] + agents.radius[j]));
  }
  EXPECT_LT(leastShare, 0.82);  // it was lowered, or that would not be tested
  EXPECT_GT(leastShare, 0.5);
}

TEST(PoissonScatter, BeginsEachGroupAtTheFullShare) {
  AgentStore agents;
  PoissonScatter scatter(seed, length, outerRadius, 900, 12e-6);
  const SurfaceFromAxis inner(innerRadius), outer(outerRadius);
  scatter.add(agents, AgentKind::iel, 60, radiusOfId, inner, inner);
  scatter.add(agents, AgentKind::smc, 5, radiusOfId, outer, outer);
  for (Index i = 0; i < agents.size(); ++i) {
    EXPECT_EQ(agents.kind[i], i < 60 ? AgentKind::iel : AgentKind::smc);
    EXPECT_NEAR(agents.position(i).head<2>().norm(), i < 60 ? innerRadius : outerRadius, 1e-12);
    for (Index j = 60; j < i; ++j)
      EXPECT_GE((agents.position(i) - agents.position(j)).norm(),
                0.82 * (agents.radius[i] + agents.radius[j]));
  }
}

}  // namespace
}  // namespace restenosis

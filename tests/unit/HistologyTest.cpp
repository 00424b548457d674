#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "bridge/surface/Histology.h"
#include "tests/support/Constants.h"

namespace restenosis {
namespace {

using namespace support;

constexpr double mm = 1e-3;

/// Laminae of 1 mm at 0.9 and 1.1 mm from the axis; the inner one lacks the agents from 0 to `gap` [rad].
AgentStore twoLaminae(double gap = 0) {
  AgentStore agents;
  for (const auto& [kind, radius] :
       {std::pair(AgentKind::iel, 0.9 * mm), std::pair(AgentKind::eel, 1.1 * mm)}) {
    const int around = 240;
    for (double z = 0; z <= mm; z += 25e-6) {
      for (int n = 0; n < around; ++n) {
        const double angle = 2 * pi * n / around;
        if (kind == AgentKind::iel && angle < gap) continue;
        agents.append(kind, Vec3(radius * std::cos(angle), radius * std::sin(angle), z), r);
      }
    }
  }
  return agents;
}

RadialMap roundLumen(double radius) {
  return RadialMap::ofRound([radius](double) { return radius; }, mm, 20e-6);
}

TEST(Histology, MeasuresConcentricRings) {
  for (const double gap : {0.0, 1.0}) {
    const AgentStore agents = twoLaminae(gap);
    const Histology histology(agents, r);
    ASSERT_TRUE(histology.possible());
    const RadialMap before = roundLumen(0.85 * mm), after = roundLumen(0.7 * mm);
    const auto sections = histology.sections(after, histology.insideIel(before));
    ASSERT_EQ(sections.size(), static_cast<std::size_t>(after.planes()));
    const double intima = pi * (0.85 * 0.85 - 0.7 * 0.7), media = pi * (1.1 * 1.1 - 0.9 * 0.9);
    for (const HistologySection& section : sections) {
      EXPECT_NEAR(section.intimaArea * 1e6, intima, 1e-3 * intima) << "gap " << gap;
      EXPECT_NEAR(section.mediaArea * 1e6, media, 1e-3 * media);
      EXPECT_NEAR(section.relativeIntimaArea, 1 - 0.7 * 0.7 / (0.85 * 0.85), 1e-3);
    }
    const HistologySection mean = Histology::mean(after, sections, 0.3 * mm, 0.6 * mm);
    EXPECT_NEAR(mean.intimaArea * 1e6, intima, 1e-3 * intima);
    EXPECT_NEAR(mean.relativeIntimaArea, 1 - 0.7 * 0.7 / (0.85 * 0.85), 1e-3);
  }
}

TEST(Histology, CountsTheCellsLumenwardOfTheInnerLine) {
  AgentStore agents = twoLaminae();
  agents.matrix.model(agents.size());
  const auto addCell = [&](double radius, double z, CycleState state, float matrix) {
    const Index i = agents.append(AgentKind::smc, Vec3(0, radius, z), r);
    agents.state[i] = state;
    agents.setCell(i, r, matrix);
  };
  const auto cellVolume = static_cast<float>(r * r * r);
  addCell(0.8 * mm, 0.2 * mm, CycleState::g1, cellVolume);
  addCell(0.8 * mm, 0.5 * mm, CycleState::g0, 0);
  addCell(1.0 * mm, 0.5 * mm, CycleState::sg2m, 0);  // of the media
  const Histology histology(agents, r);
  const RadialMap lumen = roundLumen(0.7 * mm);
  const auto sections = histology.sections(lumen, histology.insideIel(lumen));
  const HistologySection all = Histology::mean(lumen, sections, 0, mm);
  EXPECT_EQ(all.intimaCells, 2);
  EXPECT_EQ(all.inCycle(), 0.5);
  EXPECT_NEAR(all.matrixShare(), 1.0 / 3, 1e-6);
  EXPECT_NEAR(all.intimaArea, 0, 1e-15);
  const HistologySection& first = sections[static_cast<std::size_t>(lumen.nearestPlane(0.2 * mm))];
  EXPECT_EQ(first.intimaCells, 1);
  EXPECT_NEAR(first.matrixShare(), 0.5, 1e-6);
}

TEST(Histology, IsImpossibleWithoutALamina) {
  AgentStore agents;
  agents.append(AgentKind::eel, Vec3(mm, 0, 0), r);
  EXPECT_FALSE(Histology(agents, r).possible());
  EXPECT_EQ(HistologySection().inCycle(), 0);
  EXPECT_EQ(HistologySection().matrixShare(), 0);
}

}  // namespace
}  // namespace restenosis

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tissue/agents/RandomStream.h"
#include "tissue/biology/ExposureMeasure.h"

namespace restenosis {
namespace {

ContactNeighbour neighbour(const Vec3& offset, double radius = 1, AgentKind kind = AgentKind::smc) {
  return {offset, offset.norm(), radius, kind};
}

double coneShare(double cover, double radius, double distance) {
  return (1 - std::sqrt(1 - std::pow(cover * radius / distance, 2))) / 2;
}

ContactInhibitionParameters fine() {
  ContactInhibitionParameters parameters;
  parameters.directions = 1000;
  return parameters;
}

TEST(ExposureMeasure, CoversTheSolidAngleOfTheCone) {
  const ExposureMeasure measure(fine());
  const auto covered = [&](const ContactNeighbour& n) { return 1 - measure.share(1, std::vector{n}); };
  EXPECT_EQ(measure.share(1, {}), 1.0);
  // A lattice of 1000 points counts a cap of circumference s to within about s / (2 pi) sqrt(1000 / 4 pi)
  // points.
  const double tolerance = 0.006;
  const Vec3 direction = Vec3(0.3, -0.5, 0.7).normalized();
  for (const double distance : {2.0, 2.7, 4.0}) {
    EXPECT_NEAR(covered(neighbour(distance * direction)), coneShare(1.25, 1, distance), tolerance);
    EXPECT_NEAR(covered(neighbour(distance * direction, 1, AgentKind::strut)), coneShare(1.25, 1, distance),
                tolerance);
    for (const AgentKind lamina : {AgentKind::iel, AgentKind::eel}) {
      EXPECT_NEAR(covered(neighbour(distance * direction, 1, lamina)), coneShare(1.9, 1, distance),
                  tolerance);
    }
  }
  EXPECT_NEAR(covered(neighbour(3 * direction, 2)), coneShare(1.25, 2, 3), tolerance);
}

TEST(ExposureMeasure, ALaminaHidesWhatIsBehindItAndNotWhatIsBesideIt) {
  const ExposureMeasure measure(fine());
  const auto covered = [&](double facing) {
    ContactNeighbour lamina = neighbour({0, 0, 2.5}, 1, AgentKind::iel);
    lamina.facing = facing;
    return 1 - measure.share(1, std::vector{lamina});
  };
  EXPECT_NEAR(covered(1), coneShare(1.9, 1, 2.5), 0.006);
  EXPECT_NEAR(covered(0), coneShare(1.25, 1, 2.5), 0.006);
  EXPECT_NEAR(covered(std::sqrt(0.5)), coneShare((1.25 + 1.9) / 2, 1, 2.5), 0.006);
}

TEST(ExposureMeasure, ADeeplyOverlappingNeighbourCoversTheHalfSpace) {
  const ExposureMeasure measure(fine());
  EXPECT_NEAR(measure.share(1, std::vector{neighbour(Vec3(0.8, 0, 0))}), 0.5, 0.006);
  EXPECT_EQ(measure.share(1, std::vector{neighbour(Vec3(0, 0, 0))}), 1.0);
}

TEST(ExposureMeasure, IgnoresNeighboursOutOfRange) {
  const ExposureMeasure measure(fine());
  EXPECT_LT(measure.share(1, std::vector{neighbour(Vec3(0, 3.999, 0))}), 1.0);
  EXPECT_EQ(measure.share(1, std::vector{neighbour(Vec3(0, 4.001, 0))}), 1.0);
}

TEST(ExposureMeasure, TheThresholdIsTheLargestShareThatInhibits) {
  // With 60 directions, 0.15 of them are nine.
  const ExposureMeasure measure{ContactInhibitionParameters{}};
  std::vector<ContactNeighbour> neighbours;
  RandomStream random(1, 0, 0, RandomPurpose::packing);
  bool below = false, above = false, at = false;
  for (int n = 0; n < 3000; ++n) {
    neighbours.clear();
    for (int k = 0; k < 18; ++k)
      neighbours.push_back(neighbour((2 + 1.5 * random.uniform()) * random.direction()));
    const double free = std::round(60 * measure.share(1, neighbours));
    EXPECT_EQ(measure.exposed(1, neighbours), free > 9);
    below |= free<9, above |= free> 9, at |= free == 9;
  }
  EXPECT_TRUE(below && at && above);
}

}  // namespace
}  // namespace restenosis

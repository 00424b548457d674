#include <gtest/gtest.h>

#include "tissue/agents/RandomStream.h"

namespace restenosis {
namespace {

TEST(RandomStream, DependsOnEachPartOfItsKey) {
  const double reference = RandomStream(1, 2, 3, RandomPurpose::g1Duration).uniform();
  EXPECT_EQ(reference, RandomStream(1, 2, 3, RandomPurpose::g1Duration).uniform());
  EXPECT_NE(reference, RandomStream(2, 2, 3, RandomPurpose::g1Duration).uniform());
  EXPECT_NE(reference, RandomStream(1, 3, 3, RandomPurpose::g1Duration).uniform());
  EXPECT_NE(reference, RandomStream(1, 2, 4, RandomPurpose::g1Duration).uniform());
  EXPECT_NE(reference, RandomStream(1, 2, 3, RandomPurpose::divisionDirection).uniform());
}

TEST(RandomStream, HasTheMomentsOfItsDistributions) {
  const int n = 200000;
  double sum = 0, squares = 0, normals = 0, normalSquares = 0;
  RandomStream stream(7, 11, 0, RandomPurpose::packing);
  for (int k = 0; k < n; ++k) {
    const double u = stream.uniform(), g = stream.normal();
    ASSERT_GE(u, 0.0);
    ASSERT_LT(u, 1.0);
    sum += u, squares += u * u, normals += g, normalSquares += g * g;
  }
  // Five standard errors.
  EXPECT_NEAR(sum / n, 0.5, 5 * std::sqrt(1.0 / 12 / n));
  EXPECT_NEAR(squares / n, 1.0 / 3, 5 * std::sqrt(4.0 / 45 / n));
  EXPECT_NEAR(normals / n, 0.0, 5 / std::sqrt(n));
  EXPECT_NEAR(normalSquares / n, 1.0, 5 * std::sqrt(2.0 / n));
}

TEST(RandomStream, DirectionsAreUniformOnTheSphere) {
  const int n = 100000;
  Vec3 mean = Vec3::Zero(), squares = Vec3::Zero();
  for (int k = 0; k < n; ++k) {
    const Vec3 d = RandomStream(1, k, 0, RandomPurpose::divisionDirection).direction();
    ASSERT_NEAR(d.norm(), 1.0, 1e-12);
    mean += d / n, squares += d.cwiseProduct(d) / n;
  }
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(mean[axis], 0.0, 5 / std::sqrt(3.0 * n));
    EXPECT_NEAR(squares[axis], 1.0 / 3, 5 * std::sqrt(4.0 / 45 / n));
  }
}

}  // namespace
}  // namespace restenosis

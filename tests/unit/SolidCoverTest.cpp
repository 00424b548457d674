#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bridge/surface/SolidCover.h"
#include "tests/support/StrutSolids.h"
#include "tissue/parameters/LengthUnits.h"
#include "tissue/stent/StrutAgents.h"
#include "tissue/vessel/Cylindrical.h"

namespace restenosis {
namespace {

using namespace support;

constexpr double r = 15 * um, least = um;

double nearestCentre(const SolidCover& cover, const Vec3& place) {
  double nearest = HUGE_VAL;
  for (const Ball& ball : cover.balls) nearest = std::min(nearest, (ball.centre - place).norm());
  return nearest;
}

TEST(SolidCover, BallsLieInsideABoxAndAreFlushWithItsFacesEdgesAndCorners) {
  const Vec3 high(90 * um, 90 * um, 300 * um);
  const SolidCover cover = coverSolid(box(Vec3::Zero(), high), r, least);
  EXPECT_EQ(cover.tooThin, 0);
  for (const Ball& ball : cover.balls) {
    EXPECT_NEAR(ball.radius, r, 0.01 * r);
    for (int k = 0; k < 3; ++k) {
      EXPECT_GE(ball.centre[k], ball.radius * (1 - 1e-9));
      EXPECT_LE(ball.centre[k], high[k] - ball.radius * (1 - 1e-9));
    }
  }
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 set(corner & 1 ? high.x() - r : r, corner & 2 ? high.y() - r : r,
                   corner & 4 ? high.z() - r : r);
    EXPECT_LT(nearestCentre(cover, set), 0.05 * r) << corner;
  }
  for (double z = r; z <= high.z() - r; z += 2 * um)
    EXPECT_LT(nearestCentre(cover, {r, high.y() - r, z}), 0.9 * r) << z;
}

TEST(SolidCover, FacesAreCoveredAsThoseOfADesignAre) {
  const SolidCover cover = coverSolid(box(Vec3::Zero(), {90 * um, 90 * um, 300 * um}), r, least);
  // A grid of one radius leaves places 0.71 radii from the nearest centre beside it
  double farthest = 0, sum = 0;
  int places = 0;
  for (double x = r; x <= 90 * um - r; x += 3 * um)
    for (double z = r; z <= 300 * um - r; z += 3 * um, ++places) {
      const double besides = nearestCentre(cover, {x, 90 * um - r, z});
      farthest = std::max(farthest, besides);
      sum += besides;
    }
  EXPECT_LT(farthest, 0.85 * r);
  EXPECT_LT(sum / places, 0.4 * r);
}

TEST(SolidCover, ARingTakesAboutAsManyAsTheDesign) {
  VesselParameters vessel;
  vessel.length = 0.6e-3;
  const auto design = static_cast<double>(stentOfDesign(StentParameters(), vessel).spheres.size());
  const SolidCover cover = coverSolid(squareRing(0.9e-3, 90 * um, vessel.length), r, least);
  EXPECT_GT(static_cast<double>(cover.balls.size()), 0.9 * design);
  EXPECT_LT(static_cast<double>(cover.balls.size()), 1.3 * design);
  double outermost = 0, innermost = 1;
  for (const Ball& ball : cover.balls) {
    outermost = std::max(outermost, radiusOf(ball.centre) + ball.radius);
    innermost = std::min(innermost, radiusOf(ball.centre) - ball.radius);
  }
  EXPECT_NEAR(outermost, 900 * um, 0.2 * um);
  EXPECT_NEAR(innermost, 810 * um, 0.2 * um);
}

TEST(SolidCover, BallsOfATorusTouchItFromInside) {
  const double wire = 45 * um;
  const SolidCover cover = coverSolid(torus(300 * um, wire, 0, 100), r, least);
  for (const Ball& ball : cover.balls) {
    const double fromMiddle = std::hypot(radiusOf(ball.centre) - 300 * um, ball.centre.z());
    EXPECT_LT(fromMiddle + ball.radius, wire * (1 + 1e-9));
    EXPECT_GT(fromMiddle + ball.radius, wire - 0.06 * r);
  }
}

TEST(SolidCover, ThinPartsHaveBallsOfHalfTheirThickness) {
  const SolidCover plate = coverSolid(box(Vec3::Zero(), {10 * um, 90 * um, 90 * um}), r, least);
  for (const Ball& ball : plate.balls) {
    EXPECT_NEAR(ball.radius, 5 * um, 0.3 * um);
    EXPECT_NEAR(ball.centre.x(), 5 * um, 0.3 * um);
  }
  double highest = 0;
  for (const Ball& ball : plate.balls) highest = std::max(highest, ball.centre.y() + ball.radius);
  EXPECT_NEAR(highest, 90 * um, 0.2 * um);
}

TEST(SolidCover, WhatIsThinnerThanTheLeastBallIsCounted) {
  const SolidCover cover = coverSolid(box(Vec3::Zero(), {1 * um, 90 * um, 90 * um}), r, least);
  EXPECT_GT(cover.tooThin, 0.9);
}

TEST(SolidCover, PiecesAreCoveredEachByItself) {
  const TriSurface one = box(Vec3::Zero(), {60 * um, 60 * um, 60 * um});
  const TriSurface other = box({0, 0, 200 * um}, {60 * um, 60 * um, 260 * um});
  EXPECT_EQ(coverSolid(together(one, other), r, least).balls.size(),
            coverSolid(one, r, least).balls.size() + coverSolid(other, r, least).balls.size());
}

/// How far the farthest of places on a box's faces, about `step` apart and outside `other`, is from a ball.
double widestGap(const SolidCover& cover, const Vec3& low, const Vec3& high, double step,
                 const Eigen::AlignedBox3d& other) {
  double widest = 0;
  for (int axis = 0; axis < 3; ++axis)
    for (const double face : {low[axis], high[axis]})
      for (double u = step / 2; u < 1; u += step)
        for (double v = step / 2; v < 1; v += step) {
          Vec3 share = Vec3::Zero();
          share[(axis + 1) % 3] = u, share[(axis + 2) % 3] = v;
          Vec3 place = low + share.cwiseProduct(high - low);
          place[axis] = face;
          if (other.contains(place)) continue;
          double nearest = HUGE_VAL;
          for (const Ball& ball : cover.balls)
            nearest = std::min(nearest, (ball.centre - place).norm() - ball.radius);
          widest = std::max(widest, nearest);
        }
  return widest;
}

TEST(SolidCover, PiecesThatOverlapAreCoveredTogether) {
  // A link that runs into a ring, as far as half of the ring's thickness
  const Eigen::AlignedBox3d ring(Vec3::Zero(), Vec3(90 * um, 90 * um, 300 * um)),
      link(Vec3(45 * um, 15 * um, 120 * um), Vec3(250 * um, 75 * um, 180 * um));
  const SolidCover cover =
      coverSolid(together(box(ring.min(), ring.max()), box(link.min(), link.max())), r, least);
  EXPECT_EQ(cover.tooThin, 0);
  for (const Ball& ball : cover.balls) {
    const auto lies = [&ball](const Eigen::AlignedBox3d& piece) {
      return (ball.centre - piece.min()).minCoeff() >= ball.radius * (1 - 1e-9) &&
             (piece.max() - ball.centre).minCoeff() >= ball.radius * (1 - 1e-9);
    };
    EXPECT_NEAR(ball.radius, r, 0.01 * r);
    EXPECT_TRUE(lies(ring) || lies(link)) << ball.centre.transpose();
  }
  // As far from the nearest ball as the corners and edges of one box are, and no farther
  const double corner = (std::sqrt(3.0) - 1) * r;
  EXPECT_LT(widestGap(cover, ring.min(), ring.max(), 0.05, link), corner);
  EXPECT_LT(widestGap(cover, link.min(), link.max(), 0.05, ring), corner);
}

TEST(SolidCover, WhatAPieceEnclosesIsSolid) {
  const TriSurface outer = box(Vec3::Zero(), {90 * um, 90 * um, 90 * um}),
                   inner = box({20 * um, 20 * um, 20 * um}, {70 * um, 70 * um, 70 * um});
  const SolidCover whole = coverSolid(outer, r, least), nested = coverSolid(together(outer, inner), r, least);
  for (const Ball& ball : nested.balls) EXPECT_NEAR(ball.radius, r, 0.01 * r);
  for (const Ball& ball : whole.balls) EXPECT_LT(nearestCentre(nested, ball.centre), 0.7 * r);
}

}  // namespace
}  // namespace restenosis

#include <gtest/gtest.h>

#include <algorithm>

#include "tissue/neighbours/CellGrid.h"
#include "tissue/stent/StentDesign.h"
#include "tissue/stent/StrutAgents.h"
#include "tissue/vessel/Cylindrical.h"

namespace restenosis {
namespace {

class EveryDesign : public testing::TestWithParam<std::string_view> {
 protected:
  EveryDesign() {
    parameters.design = GetParam();
    parameters.length = 1.6e-3;
    parameters.ringCount = 3;
    parameters.ringAmplitude = 0.1e-3;
    parameters.helixTurns = 3;
    vessel.length = 2e-3;
    vessel.lumenDiameter = 1.8e-3;
  }
  StentParameters parameters;
  VesselParameters vessel;
};

TEST_P(EveryDesign, HasItsOuterFaceAtTheLumenAndThenAtTheDepth) {
  const Stent stent = stentOfDesign(parameters, vessel);
  ASSERT_FALSE(stent.segments.empty());
  for (const double depth : {0.0, 110e-6}) {
    const Stent moved = stent.movedOutwards(depth);
    const double face = 0.9e-3 + depth;
    double outermost = 0;
    for (std::size_t n = 0; n < moved.spheres.size(); ++n) {
      outermost = std::max(outermost, radiusOf(moved.centre(n)) + moved.spheres[n].radius);
    }
    EXPECT_NEAR(outermost, face, 1e-9);
    for (const StrutSegment& segment : moved.segments) {
      const Vec3 middle = 0.5 * (segment.a + segment.b);
      EXPECT_NEAR(radiusOf(middle) + segment.thickness / 2, face, 0.11e-6);
      EXPECT_NEAR(segment.radial.norm(), 1, 1e-12);
      EXPECT_NEAR(segment.radial.dot(segment.b - segment.a), 0, 1e-12);
    }
  }
}

TEST_P(EveryDesign, SpansTheStentsLengthAndStaysInIt) {
  double low = 1, high = 0;
  for (const StrutSegment& segment : stentOfDesign(parameters, vessel).segments) {
    low = std::min({low, segment.a.z(), segment.b.z()});
    high = std::max({high, segment.a.z(), segment.b.z()});
  }
  const bool spans = stentDesign(parameters.design).spansLength;
  const double reach = spans ? 0.8e-3 - 45e-6 : 0;
  EXPECT_NEAR(low, 1e-3 - reach, 1e-6);  // the crests of a sampled sine fall a little short
  EXPECT_NEAR(high, 1e-3 + reach, 1e-6);
}

TEST_P(EveryDesign, SpheresFillTheBoxesWithoutNotchesOrLeaks) {
  const Stent stent = stentOfDesign(parameters, vessel);
  // Every sphere's centre lies inside the struts; the box is flat where the sphere follows the cylinder,
  // which costs at most 45^2 / (2 * 855) um at a link's edge.
  for (std::size_t n = 0; n < stent.spheres.size(); ++n) {
    const Vec3 centre = stent.centre(n);
    const std::size_t segment = stent.spheres[n].segment;
    double nearest = 1;
    const std::size_t from = segment > 3 ? segment - 3 : 0;
    for (std::size_t m = from; m < std::min(segment + 4, stent.segments.size()); ++m) {
      nearest = std::min(nearest, StrutDistance(stent.segments[m])(centre));
    }
    ASSERT_LT(nearest, -stent.spheres[n].radius + 2.1e-6);
  }
  // No place on the outer face is further from the next sphere than a cell could slip into: half the face
  // diagonal of spacing r from the nearest centre in the plane one radius below.
  const CellGrid grid(
      stent.spheres.size(), [&](std::size_t n) { return stent.centre(n); }, 30e-6);
  for (const StrutSegment& segment : stent.segments) {
    const Vec3 across = (segment.b - segment.a).normalized().cross(segment.radial);
    for (const double w : {-30e-6, 0.0, 30e-6}) {
      const Vec3 place = 0.5 * (segment.a + segment.b) + w * across + 30e-6 * segment.radial;
      double nearest = 1;
      grid.forEachCandidate(place, 40e-6,
                            [&](Index n) { nearest = std::min(nearest, (stent.centre(n) - place).norm()); });
      ASSERT_LT(nearest, 13e-6);
    }
  }
}

TEST_P(EveryDesign, ChainsHaveNoNotches) {
  const auto segments = stentOfDesign(parameters, vessel).segments;
  const auto distance = [&](const Vec3& point) {
    double nearest = 1;
    for (const StrutSegment& segment : segments) nearest = std::min(nearest, StrutDistance(segment)(point));
    return nearest;
  };
  for (std::size_t n = 0; n + 1 < segments.size(); n += 7) {
    if ((segments[n].b - segments[n + 1].a).norm() > 1e-9) continue;
    const Vec3 along = (segments[n + 1].b - segments[n].a).normalized();
    const Vec3 out = radialAt(segments[n].b), across = along.cross(out);
    for (const double side : {-1.0, 1.0}) {
      EXPECT_LT(distance(segments[n].b + side * 44e-6 * across), 0);
      EXPECT_LT(distance(segments[n].b + side * 44e-6 * out), 0);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Designs, EveryDesign, testing::ValuesIn(stentDesignNames()),
                         [](const auto& design) { return std::string(design.param); });

TEST(StentDesign, RingHasTheVolumeOfARing) {
  VesselParameters vessel;
  vessel.length = 1e-3;
  const Stent stent = stentOfDesign(StentParameters(), vessel);
  double length = 0;
  for (const StrutSegment& segment : stent.segments) length += segment.length();
  EXPECT_NEAR(length, 2 * std::numbers::pi * 0.855e-3, 1e-6);
}

TEST(StentDesign, RoundStrutsAreFlushToo) {
  StentParameters parameters;
  parameters.strutShape = "round";
  const Stent stent = stentOfDesign(parameters, VesselParameters());
  double outermost = 0;
  for (std::size_t n = 0; n < stent.spheres.size(); ++n) {
    outermost = std::max(outermost, radiusOf(stent.centre(n)) + stent.spheres[n].radius);
  }
  EXPECT_NEAR(outermost, 0.9e-3, 1e-9);
}

TEST(StentDesign, ThinStrutsGetSmallSpheres) {
  StentParameters parameters;
  parameters.strutWidth = parameters.strutThickness = 20e-6;
  const Stent stent = stentOfDesign(parameters, VesselParameters());
  for (const StrutSphere& sphere : stent.spheres) EXPECT_DOUBLE_EQ(sphere.radius, 10e-6);
}

TEST(StentDesign, UnknownNameListsTheDesigns) {
  try {
    stentDesign("spiral");
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(),
                 "unknown stent design 'spiral'; allowed are ring, rings, ringsWithLinks, helix, biodivysio");
  }
}

}  // namespace
}  // namespace restenosis

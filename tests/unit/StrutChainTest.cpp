#include <gtest/gtest.h>

#include "tests/support/Constants.h"
#include "tissue/stent/StentDesign.h"
#include "tissue/stent/StrutChain.h"
#include "tissue/vessel/Cylindrical.h"

namespace restenosis {
namespace {

using namespace support;

class StrutChain : public testing::Test {
 protected:
  StrutChain() {
    stent.strutWidth = 80e-6;
    stent.strutThickness = 60e-6;
  }
  double totalLength() const {
    double sum = 0;
    for (const StrutSegment& segment : segments) sum += segment.length();
    return sum;
  }
  StentParameters stent;
  StentLayout layout{.vesselLength = 5e-3, .outerRadius = vesselRadius};
  double middleRadius = vesselRadius - 30e-6;  ///< of centrelines [m]
  std::vector<StrutSegment> segments;
};

TEST_F(StrutChain, TheLongestSegmentIsATenthOfAMicrometreOffItsArc) {
  const double half = longestSegment(vesselRadius) / 2;
  EXPECT_NEAR(vesselRadius - std::sqrt(vesselRadius * vesselRadius - half * half), 0.1e-6, 1e-10);
}

TEST_F(StrutChain, ARingIsAClosedPolygon) {
  appendRing(segments, 1e-3, 0, 0, 0, stent, layout);
  const auto count = static_cast<double>(segments.size());
  EXPECT_GE(count, 2 * pi * vesselRadius / longestSegment(vesselRadius));
  EXPECT_NEAR(totalLength(), 2 * count * middleRadius * std::sin(pi / count), 1e-12);
  for (const StrutSegment& segment : segments) {
    EXPECT_FALSE(segment.openA || segment.openB);
    EXPECT_DOUBLE_EQ(segment.a.z(), 1e-3);
    EXPECT_NEAR(segment.overlap, 80e-6 * 0.5 * std::tan(pi / count), 1e-12);
    EXPECT_NEAR(radiusOf(0.5 * (segment.a + segment.b)), middleRadius * std::cos(pi / count), 1e-12);
  }
}

TEST_F(StrutChain, ASinusoidalRingHasItsAmplitude) {
  appendRing(segments, 1e-3, 0.1e-3, 6, pi / 2, stent, layout);
  double low = 1, high = 0;
  for (const StrutSegment& segment : segments) {
    const Cylindrical a = toCylindrical(segment.a);
    EXPECT_NEAR(a.z, 1e-3 + 0.1e-3 * std::cos(6 * a.angle), 1e-12);
    low = std::min(low, a.z), high = std::max(high, a.z);
  }
  EXPECT_NEAR(high - low, 0.2e-3, 0.2e-6);
}

TEST_F(StrutChain, AHelixIsOpenAtItsEndsOnly) {
  appendLine(segments, {0, 1e-3}, {4 * pi, 2e-3}, stent, layout);
  const double expected = std::hypot(4 * pi * middleRadius, 1e-3);
  EXPECT_NEAR(totalLength(), expected, 1e-4 * expected);
  for (std::size_t n = 0; n < segments.size(); ++n) {
    EXPECT_EQ(segments[n].openA, n == 0);
    EXPECT_EQ(segments[n].openB, n + 1 == segments.size());
    EXPECT_TRUE(n == 0 || segments[n].a == segments[n - 1].b) << n;
  }
}

TEST_F(StrutChain, SegmentsOverlapByHalfTheirWidthAtARightAngle) {
  const std::array<SurfacePoint, 3> corner = {{{0, 1e-3}, {0, 1.02e-3}, {0.02, 1.02e-3}}};
  appendChain(segments, corner, stent, layout);
  ASSERT_EQ(segments.size(), 2u);
  for (const StrutSegment& segment : segments) EXPECT_NEAR(segment.overlap, 40e-6, 1e-15);
  segments.clear();
  appendChain(segments, std::span(corner).first(2), stent, layout);
  ASSERT_EQ(segments.size(), 1u);
  EXPECT_EQ(segments[0].overlap, 0);
  EXPECT_TRUE(segments[0].openA && segments[0].openB);
  appendLine(segments, {0, 1e-3}, {0, 2e-3}, stent, layout);
  EXPECT_NEAR(segments.back().overlap, 0.005 * 80e-6, 1e-15) << "straight";
}

TEST_F(StrutChain, RingsAreEvenlySpacedOverTheStent) {
  stent.length = 3e-3;
  EXPECT_EQ(ringPlaces(1, 0.1e-3, stent, layout), std::vector<double>{2.5e-3});
  const std::vector<double> places = ringPlaces(4, 0.1e-3, stent, layout);
  ASSERT_EQ(places.size(), 4u);
  for (int n = 0; n < 4; ++n) EXPECT_NEAR(places[n], 1.1e-3 + 2.8e-3 * n / 3, 1e-15);
}

TEST_F(StrutChain, RingsThatOverlapAreAProblem) {
  stent.length = 3e-3;
  stent.ringCount = 3;
  EXPECT_TRUE(checkRingsOf(1e-3, stent).empty());
  const std::vector<ParameterProblem> problems = checkRingsOf(1.01e-3, stent);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0].key, "stent.ringCount");
  EXPECT_NE(problems[0].message.find("at least 3.03 mm"), std::string::npos) << problems[0].message;
}

}  // namespace
}  // namespace restenosis

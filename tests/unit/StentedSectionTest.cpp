#include <gtest/gtest.h>

#include "bridge/coupling/StentedSection.h"

namespace restenosis {
namespace {

constexpr double vesselLength = 2e-3, strutWidth = 0.1e-3;

StrutSegment strutBetween(double fromZ, double toZ) {
  StrutSegment segment{};
  segment.a = {0.9e-3, 0, fromZ}, segment.b = {0, 0.9e-3, toZ};
  segment.width = strutWidth;
  return segment;
}

Stent stentOf(std::vector<StrutSegment> segments) {
  Stent stent;
  stent.segments = std::move(segments);
  return stent;
}

TEST(StentedSection, IsAllOfAVesselWithoutAStent) {
  EXPECT_EQ(stentedSection({}, vesselLength).from, 0);
  EXPECT_EQ(histologySection({}, vesselLength).to, vesselLength);
}

TEST(StentedSection, HasAMarginBesideTheOutermostStrutsWhichPathologistsDoNotCut) {
  const std::optional<Stent> stent = stentOf({strutBetween(0.5e-3, 0.8e-3), strutBetween(1.5e-3, 1.2e-3)});
  EXPECT_DOUBLE_EQ(stentedSection(stent, vesselLength).from, 0.25e-3);
  EXPECT_DOUBLE_EQ(stentedSection(stent, vesselLength).to, 1.75e-3);
  EXPECT_DOUBLE_EQ(histologySection(stent, vesselLength).from, 0.5e-3);
  EXPECT_DOUBLE_EQ(histologySection(stent, vesselLength).to, 1.5e-3);
}

TEST(StentedSection, EndsWithTheVessel) {
  const std::optional<Stent> stent = stentOf({strutBetween(0.1e-3, 1.9e-3)});
  EXPECT_EQ(stentedSection(stent, vesselLength).from, 0);
  EXPECT_EQ(stentedSection(stent, vesselLength).to, vesselLength);
}

TEST(StentedSection, OfASingleRingHistologyIsMeasuredBesideItToo) {
  const std::optional<Stent> ring = stentOf({strutBetween(1e-3, 1e-3)});
  EXPECT_DOUBLE_EQ(histologySection(ring, vesselLength).from, 0.75e-3);
  EXPECT_DOUBLE_EQ(histologySection(ring, vesselLength).to, 1.25e-3);
}

}  // namespace
}  // namespace restenosis

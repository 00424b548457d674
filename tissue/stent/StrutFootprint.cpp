#include "tissue/stent/StrutFootprint.h"

#include "tissue/vessel/Cylindrical.h"

namespace restenosis {
namespace {

double meanRadius(const Stent& stent) {
  double sum = 0;
  for (const StrutSegment& segment : stent.segments) sum += radiusOf(0.5 * (segment.a + segment.b));
  return stent.segments.empty() ? 1.0 : sum / static_cast<double>(stent.segments.size());
}

double longestReach(const Stent& stent) {
  double reach = 1e-9;
  for (const StrutSegment& segment : stent.segments) {
    reach = std::max(reach, segment.length() / 2 + segment.overlap + segment.width);
  }
  return reach;
}

std::vector<Vec3> middlesOf(const Stent& stent, double radius) {
  std::vector<Vec3> middles;
  for (const StrutSegment& segment : stent.segments)
    middles.push_back(atRadius(0.5 * (segment.a + segment.b), radius));
  return middles;
}

}  // namespace

StrutFootprint::StrutFootprint(const Stent& stent)
    : stent_(stent),
      radius_(meanRadius(stent)),
      reach_(longestReach(stent)),
      middles_(middlesOf(stent, radius_)),
      grid_(
          middles_.size(), [this](std::size_t n) -> const Vec3& { return middles_[n]; }, reach_) {}

Vec3 StrutFootprint::onSurface(const Vec3& place) const { return atRadius(place, radius_); }

bool StrutFootprint::holds(Index index, const Vec3& place, double margin, Hit& hit) const {
  const StrutSegment& segment = stent_.segments[index];
  const Vec3 middle = 0.5 * (segment.a + segment.b);
  const double length = segment.length();
  const Vec3 along = length > 0 ? Vec3((segment.b - segment.a) / length) : Vec3(Vec3::UnitZ());
  const Vec3 offset = atRadius(place, radiusOf(middle)) - middle;
  const double ends = length > 0 ? length / 2 + segment.overlap : segment.width / 2 - margin;
  const double across = std::abs(offset.dot(along.cross(segment.radial)));
  if (std::abs(offset.dot(along)) > ends || across > segment.width / 2 - margin) return false;
  hit = {.segment = index, .across = across, .outerFace = radiusOf(segment.a) + segment.thickness / 2};
  return true;
}

}  // namespace restenosis

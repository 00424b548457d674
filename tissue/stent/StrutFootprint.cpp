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

PointGrid emptyGrid(const Stent& stent, double radius, double cell) {
  Vec3 low(-radius, -radius, 0), high(radius, radius, 0);
  for (const StrutSegment& segment : stent.segments) {
    low.z() = std::min({low.z(), segment.a.z(), segment.b.z()});
    high.z() = std::max({high.z(), segment.a.z(), segment.b.z()});
  }
  return {low, high, cell};
}

}  // namespace

StrutFootprint::StrutFootprint(const Stent& stent)
    : stent_(stent),
      radius_(meanRadius(stent)),
      reach_(longestReach(stent)),
      grid_(emptyGrid(stent, radius_, reach_)) {
  for (std::size_t n = 0; n < stent.segments.size(); ++n) {
    const StrutSegment& segment = stent.segments[n];
    grid_.insert(static_cast<Index>(n), onSurface(0.5 * (segment.a + segment.b)));
  }
}

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

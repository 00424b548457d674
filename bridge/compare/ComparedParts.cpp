#include "ComparedParts.h"

#include "LumenShape.h"
#include "PointTree.h"

namespace restenosis {

std::string_view partName(ComparedPart part) {
  switch (part) {
    case ComparedPart::smoothWall:
      return "smoothWall";
    case ComparedPart::betweenStruts:
      return "betweenStruts";
    case ComparedPart::strut:
      return "strut";
    case ComparedPart::ends:
      return "ends";
  }
  return "";
}

ComparedFaces comparedFaces(const TriSurface& lumen, const ComparedPartsSettings& settings) {
  std::vector<Vec3> struts;
  for (std::size_t t = 0; t < lumen.triangles.size(); ++t)
    if (lumen.region[t] == SurfaceRegion::strut) struts.push_back(lumen.centre(t));
  const PointTree tree(std::move(struts));
  const double first = lumenEnd(lumen, SurfaceRegion::inlet).z + settings.endLength,
               last = lumenEnd(lumen, SurfaceRegion::outlet).z - settings.endLength;
  const auto partOf = [&](std::size_t t) {
    const Vec3 centre = lumen.centre(t);
    if (centre.z() < first || centre.z() > last) return ComparedPart::ends;
    if (lumen.region[t] == SurfaceRegion::strut) return ComparedPart::strut;
    const auto nearest = tree.nearest(centre, 1);
    return !nearest.empty() && nearest.front().distance < settings.strutReach ? ComparedPart::betweenStruts
                                                                              : ComparedPart::smoothWall;
  };
  ComparedFaces faces;
  for (std::size_t t = 0; t < lumen.triangles.size(); ++t) {
    if (lumen.region[t] != SurfaceRegion::wall && lumen.region[t] != SurfaceRegion::strut) continue;
    faces.triangle.push_back(static_cast<std::uint32_t>(t));
    faces.part.push_back(partOf(t));
    faces.area.push_back(lumen.areaVector(t).norm());
  }
  return faces;
}

}  // namespace restenosis

#include "bridge/flow/RegionalFaces.h"

namespace restenosis {
namespace {

std::vector<const WallFace*> facesOf(const std::vector<WallFace>& faces, SurfaceRegion region) {
  std::vector<const WallFace*> found;
  for (const WallFace& face : faces)
    if (face.region == region) found.push_back(&face);
  return found;
}

std::vector<Vec3> centresOf(const std::vector<const WallFace*>& faces) {
  std::vector<Vec3> centres;
  for (const WallFace* face : faces) centres.push_back(face->centre);
  return centres;
}

}  // namespace

RegionalFaces::Part::Part(std::vector<const WallFace*> given)
    : faces(std::move(given)), tree(centresOf(faces)) {}

RegionalFaces::RegionalFaces(const std::vector<WallFace>& faces)
    : wall_(facesOf(faces, SurfaceRegion::wall)), strut_(facesOf(faces, SurfaceRegion::strut)) {}

std::vector<RegionalFaces::Near> RegionalFaces::nearest(const Vec3& place, SurfaceRegion region,
                                                        std::size_t count) const {
  const Part& part = region == SurfaceRegion::strut ? strut_ : wall_;
  std::vector<Near> result;
  for (const auto& near : part.tree.nearest(place, count))
    result.push_back({part.faces[near.index], near.distance});
  return result;
}

}  // namespace restenosis

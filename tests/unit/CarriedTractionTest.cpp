#include <gtest/gtest.h>

#include "bridge/compare/CarriedTraction.h"
#include "tests/support/Constants.h"
#include "tests/support/FlowSupport.h"
#include "tests/support/TubeSurface.h"

namespace restenosis {
namespace {

using namespace support;

/// A flow whose faces are the triangles of a surface, with the traction of a function of the place.
template <class Traction>
FlowSolution flowOn(const TriSurface& s, const Traction& traction) {
  FlowSolution flow;
  for (std::size_t t = 0; t < s.triangles.size(); ++t)
    if (s.region[t] == SurfaceRegion::wall || s.region[t] == SurfaceRegion::strut)
      flow.wall.push_back({s.centre(t), s.areaVector(t).norm(), traction(s.centre(t)), s.region[t]});
  return flow;
}

TEST(CarriedTraction, toTheTrianglesThemselvesChangesNothing) {
  const TriSurface lumen = stentedTube(vesselRadius, vesselLength, 90e-6);
  const auto faces = comparedFaces(lumen);
  const auto flow = flowOn(lumen, [](const Vec3& p) { return p; });
  const auto carried = carriedTraction(lumen, faces, flow);
  for (std::size_t i = 0; i < faces.size(); ++i) EXPECT_EQ(carried[i], lumen.centre(faces.triangle[i]));
}

TEST(CarriedTraction, fromOtherFacesFollowsTheField) {
  const TriSurface lumen = tube(vesselRadius, vesselLength, 40), other = tube(vesselRadius, vesselLength, 57);
  const auto faces = comparedFaces(lumen);
  const auto flow = flowOn(other, [](const Vec3& p) { return Vec3(0.0, 0.0, p.z()); });
  const auto carried = carriedTraction(lumen, faces, flow);
  for (std::size_t i = 0; i < faces.size(); ++i)
    EXPECT_NEAR(carried[i].z(), lumen.centre(faces.triangle[i]).z(), vesselLength / 57);
}

TEST(CarriedTraction, strutsTakeNothingFromTheWall) {
  const TriSurface lumen = stentedTube(vesselRadius, vesselLength, 90e-6);
  const auto faces = comparedFaces(lumen);
  const auto flow = flowOn(tube(vesselRadius, vesselLength), [](const Vec3&) { return Vec3(0, 0, 1); });
  const auto carried = carriedTraction(lumen, faces, flow);
  for (std::size_t i = 0; i < faces.size(); ++i)
    EXPECT_EQ(std::isnan(carried[i].z()), lumen.region[faces.triangle[i]] == SurfaceRegion::strut);
}

}  // namespace
}  // namespace restenosis

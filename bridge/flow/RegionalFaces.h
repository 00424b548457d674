#pragma once

#include <vector>

#include "bridge/flow/FlowBackend.h"
#include "bridge/surface/PointTree.h"

namespace restenosis {

/// The faces of a flow's wall nearest to a place, those of wall and struts kept apart: beside a strut the
/// nearest face of any region may be one of a very different stress. The faces must outlive it.
class RegionalFaces {
 public:
  explicit RegionalFaces(const std::vector<WallFace>& faces);

  struct Near {
    const WallFace* face;
    double distance;  ///< of its centre [m]
  };
  /// At most `count` faces of the region (struts, or the wall for all others), the nearest first. None where
  /// the flow has no face of that region.
  std::vector<Near> nearest(const Vec3& place, SurfaceRegion region, std::size_t count) const;

 private:
  struct Part {
    explicit Part(std::vector<const WallFace*> given);
    std::vector<const WallFace*> faces;
    PointTree tree;
  };
  Part wall_, strut_;
};

}  // namespace restenosis

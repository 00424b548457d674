#pragma once

#include <cstdint>
#include <vector>

#include "bridge/surface/TriSurface.h"

namespace restenosis {

/// Smoothed normals of wall and struts: of the faces around the vertices of each face the area-weighted mean,
/// those that meet it at more than 45 degrees left out.
class SmoothNormals {
 public:
  /// The surface must outlive this.
  explicit SmoothNormals(const TriSurface& surface);
  Vec3 at(std::size_t face) const;

 private:
  template <class F>
  void forEachCorner(F&& f) const;

  const TriSurface& surface_;
  std::vector<std::uint32_t> first_,
      faces_;  ///< faces around vertex v: faces_[first_[v]] to below first_[v + 1]
};

}  // namespace restenosis

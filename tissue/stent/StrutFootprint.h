#pragma once

#include <vector>

#include "tissue/neighbours/CellGrid.h"
#include "tissue/stent/Stent.h"

namespace restenosis {

/// Finds the segments of struts over or under a place as seen from the axis: those at its angle and z.
class StrutFootprint {
 public:
  explicit StrutFootprint(const Stent& stent);

  /// Where a place lies relative to the strut it is over or under.
  struct Hit {
    std::size_t segment;
    double across;     ///< distance from the centreline along the surface, not negative [m]
    double outerFace;  ///< distance of the strut's outer face from the axis [m]
  };
  /// Calls f(hit) for each segment with the place in its footprint, made narrower by `margin` on both sides.
  template <class F>
  void visit(const Vec3& place, double margin, F&& f) const {
    const Vec3 here = onSurface(place);
    grid_.forEachCandidate(here, reach_, [&](Index n) {
      Hit hit{};
      if ((middles_[n] - here).squaredNorm() < reach_ * reach_ && holds(n, place, margin, hit)) f(hit);
    });
  }

 private:
  Vec3 onSurface(const Vec3& place) const;
  bool holds(Index segment, const Vec3& place, double margin, Hit& hit) const;

  const Stent& stent_;
  double radius_;  ///< of the cylinder on which footprints are compared [m]
  double reach_;
  std::vector<Vec3> middles_;  ///< of the segments, on that cylinder [m]
  CellGrid grid_;              ///< of the middles
};

}  // namespace restenosis

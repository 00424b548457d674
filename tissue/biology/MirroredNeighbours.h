#pragma once

#include <cmath>
#include <vector>

#include "AgentShapes.h"
#include "CellGrid.h"
#include "ContactInhibitionLaw.h"

namespace restenosis {

/// Neighbours in a wall that goes on beyond the ends of the vessel as its own mirror image: in the planes z =
/// 0 and z = length. The agents must not change while it is in use.
class MirroredNeighbours {
 public:
  /// For neighbours within up to `range` (R1 + R2). `vesselLength` [m]; 0: no ends, no images.
  MirroredNeighbours(const AgentShapes& agents, double range, double vesselLength);

  /// Calls f(j, offset, distance) for each agent and each image of one within `range` (radius + R_j) of
  /// `centre`, `offset` pointing to it. An agent at `centre` is among them. No stated order; several threads
  /// may ask.
  template <class F>
  void forEachWithin(double range, const Vec3& centre, double radius, F&& f) const {
    search(range, centre, radius, f);
    if (vesselLength_ <= 0) return;
    const double reach = range * (radius + largestRadius_);
    if (centre.z() < reach) searchImages(range, centre, 0.0, radius, f);
    if (vesselLength_ - centre.z() < reach) searchImages(range, centre, vesselLength_, radius, f);
  }

  double range() const { return range_; }

  /// Fills `found` with the neighbours of agent `i` within `range` (R1 + R2). The images of others are never
  /// nearer than they are themselves; its own image is a neighbour only where it does not overlap the agent:
  /// nearer to the plane the others' images go round the agent as they do inside the wall.
  void gather(Index i, double range, std::vector<ContactNeighbour>& found) const;

 private:
  /// Cosine between `offset`, which leads to agent j, and the radius of the vessel there: the laminae's
  /// normal.
  double facing(Index j, const Vec3& offset, double distance) const;

  template <class F>
  void search(double range, const Vec3& centre, double radius, F&& f) const {
    grid_.forEachCandidate(centre, range * (radius + largestRadius_), [&](Index j) {
      const Vec3 offset = agents_.position(j) - centre;
      const double reach = range * (radius + agents_.radius[j]);
      const double squared = offset.squaredNorm();
      if (squared <= reach * reach) f(j, offset, std::sqrt(squared));
    });
  }
  /// Images in the plane at `plane` are as far from `centre` as the agents themselves are from its image.
  template <class F>
  void searchImages(double range, const Vec3& centre, double plane, double radius, F&& f) const {
    const Vec3 image(centre.x(), centre.y(), 2 * plane - centre.z());
    search(range, image, radius, [&f](Index j, const Vec3& offset, double distance) {
      f(j, Vec3(offset.x(), offset.y(), -offset.z()), distance);
    });
  }

  AgentShapes agents_;
  double range_;
  double vesselLength_;
  double largestRadius_;
  CellGrid grid_;
};

}  // namespace restenosis

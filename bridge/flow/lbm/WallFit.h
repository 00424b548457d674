#pragma once

#include <cstdint>
#include <vector>

#include "TriSurface.h"

namespace restenosis {

/// A node near a face, and what it counts.
struct NearNode {
  std::uint32_t place;
  Vec3 offset;  ///< from the face's centre [spacings]
  double weight;
};

/// Turns the weights of a linear least-squares fit around a face into those of its value at the face's
/// centre. Few nodes give their mean.
void fitValue(std::vector<NearNode>& nodes);

/// Turns them into those of the derivative along the inward normal, at the face's centre, of a quantity that
/// vanishes on the wall: fitted are d, d^2, d s, d t, s^2, s t, t^2 with the distance d from the tangent
/// plane and s, t in it; the last three let the wall bend. Where the nodes do not determine these, d alone.
void fitWallDerivative(std::vector<NearNode>& nodes, const Vec3& outwardNormal);

/// Leaves the nearest node alone, with weight 1.
void keepNearest(std::vector<NearNode>& nodes);

}  // namespace restenosis

#pragma once

#include <cstdint>
#include <vector>

#include "bridge/surface/TriSurface.h"

namespace restenosis {

/// A node near a face, and what it counts.
struct NearNode {
  std::uint32_t place;
  Vec3 offset;  ///< from the face's centre [spacings]
  double weight;
  double wallDistance = 0.0;  ///< from the nearest place of the wall [spacings]; what fitWallRatio and
                              ///< keepFacing go by
};

/// Leaves out nodes that are nearer to another face of the wall than to the plane of this one: beyond an edge
/// of it, a quantity that vanishes on the wall does not vanish on the plane. Too few would be left: keeps
/// all.
void keepFacing(std::vector<NearNode>& nodes, const Vec3& outwardNormal);

/// Turns the weights of a linear least-squares fit around a face into those of its value at the face's
/// centre. Few nodes give their mean.
void fitValue(std::vector<NearNode>& nodes);

/// Turns them into those of the derivative along the inward normal, at the face's centre, of a quantity that
/// vanishes on the wall: fitted are d, d^2, d s, d t, s^2, s t, t^2 with the distance d from the tangent
/// plane and s, t in it; the last three let the wall bend. Where the nodes do not determine these, d alone.
void fitWallDerivative(std::vector<NearNode>& nodes, const Vec3& outwardNormal);

/// Turns them into those of the derivative along the normal, at the face, of a quantity that vanishes on the
/// wall, whatever shape the wall has there: its ratio to the wall distance is fitted by a linear function,
/// whose value at the face's centre is the derivative. Nodes count by the inverse square of their distance,
/// so that it is the ratio whose deviation is least. Slopes are held back by a ridge. Few nodes, or a fit
/// that would enlarge their errors, give the mean ratio.
void fitWallRatio(std::vector<NearNode>& nodes);

/// Leaves the nearest node alone, with weight 1.
void keepNearest(std::vector<NearNode>& nodes);

}  // namespace restenosis

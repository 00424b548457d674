#pragma once

#include <Eigen/Geometry>
#include <cmath>

#include "tissue/agents/AgentStore.h"

namespace restenosis {

/// The rotation by the smallest angle that turns one direction into another; of opposite directions, by half
/// a turn about some axis. (Eigen's FromTwoVectors instantiates a singular value decomposition, which costs
/// half a minute of compilation wherever it is used.)
inline Eigen::Matrix3d rotationOnto(const Vec3& from, const Vec3& to) {
  const Vec3 across = from.cross(to);
  const double sine = across.norm(), cosine = from.dot(to);
  if (sine == 0.0 && cosine >= 0.0) return Eigen::Matrix3d::Identity();
  const Vec3 axis = sine > 0.0 ? Vec3(across / sine) : from.unitOrthogonal();
  return Eigen::AngleAxisd(std::atan2(sine, cosine), axis).toRotationMatrix();
}

}  // namespace restenosis

#pragma once

#include "tissue/agents/AgentStore.h"

namespace restenosis {

/// A restriction on where agents may be, applied by a relaxation after every move: the packing's cylinders
/// for the laminae, the vessel's end planes, the surface that keeps cells inside the EEL.
class Constraint {
 public:
  /// An agent this close to a curved surface, over its distance from the axis, counts as on it. Sliding along
  /// moves it off by a little, and the force that presses it on would count as a residual, which comes and
  /// goes with every move. A nanometre in a coronary artery.
  static constexpr double onSurface = 1e-6;

  virtual ~Constraint() = default;
  /// Moves `position`, where an agent of this kind and radius [m] is about to go, to the nearest allowed
  /// place.
  virtual void project(AgentKind kind, double radius, Vec3& position) const = 0;
  /// How far, at least, an agent may go from `position` in any direction before project() or release() do
  /// anything [m]: infinity for those it never concerns, 0 or less where they may do so here. Where an agent
  /// has a margin neither is called.
  virtual double margin(AgentKind kind, double radius, const Vec3& position) const = 0;
  /// Removes the part of the `force` on an agent at `position` that the constraint carries there, so that
  /// what is left is the residual.
  virtual void release(AgentKind kind, double radius, const Vec3& position, Vec3& force) const = 0;
};

}  // namespace restenosis

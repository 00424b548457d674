#pragma once

#include "tissue/equilibrium/Constraint.h"

namespace restenosis {

/// Keeps centres between the vessel's ends, 0 <= z <= length: no agent leaves the modelled segment.
class EndPlanes : public Constraint {
 public:
  explicit EndPlanes(double length) : length_(length) {}
  void project(AgentKind kind, double radius, Vec3& position) const override;
  double margin(AgentKind kind, double radius, const Vec3& position) const override;
  void release(AgentKind kind, double radius, const Vec3& position, Vec3& force) const override;

 private:
  double length_;
};

}  // namespace restenosis

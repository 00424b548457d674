#pragma once

#include "tissue/equilibrium/Constraint.h"
#include "tissue/vessel/WallShape.h"

namespace restenosis {

/// For packing: a lamina's agents slide on its surface, and cells stay between the surfaces `inner` and
/// `outer`. Positions are corrected along the radius; force is removed along the surface's normal.
class LaminaSurfaces : public Constraint {
 public:
  /// `shape` must outlive the object.
  explicit LaminaSurfaces(const WallShape& shape) : shape_(shape) {}
  void project(AgentKind kind, double radius, Vec3& position) const override;
  double margin(AgentKind kind, double radius, const Vec3& position) const override;
  void release(AgentKind kind, double radius, const Vec3& position, Vec3& force) const override;

 private:
  const WallShape& shape_;
};

}  // namespace restenosis

#pragma once

#include "tissue/equilibrium/Constraint.h"
#include "tissue/vessel/RadiusMap.h"

namespace restenosis {

/// Keeps cells inside the EEL by a surface: between the spheres of the lamina a pressed cell would leak
/// (model 4). The surface is the smooth radius map of the EEL agents; a cell's centre stays `margin` of its
/// radius inside it. It acts radially.
///
/// The surface is that of the agents when it was made: make a new one after the EEL has moved.
class OuterConfinement : public Constraint {
 public:
  OuterConfinement() = default;  ///< confines nothing
  /// `cellRadius` is the mean radius of the wall's agents [m]; the surface is smoothed over twice that.
  OuterConfinement(const AgentStore& agents, double cellRadius, double margin = defaultMargin);

  /// Half a radius (assumed): a cell at rest beside the EEL stays further in, so that the surface carries
  /// nothing there.
  static constexpr double defaultMargin = 0.5;

  void project(AgentKind kind, double radius, Vec3& position) const override;
  double margin(AgentKind kind, double radius, const Vec3& position) const override;
  void release(AgentKind kind, double radius, const Vec3& position, Vec3& force) const override;

  template <class Archive>
  void archive(Archive& a) {
    a(map_, margin_);
  }

 private:
  /// The distance from the axis [m] below which an agent is farther in than what release() takes for on the
  /// surface, where that is `surface` from the axis.
  double clearlyInside(double surface, double radius) const;
  /// True of most agents, at the cost of a few multiplications: so far inside that the surface cannot act.
  bool deepInside(const Vec3& position, double radius) const;

  RadiusMap map_;
  double margin_ = defaultMargin;
};

}  // namespace restenosis
